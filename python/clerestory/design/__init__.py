"""Design: the panel, and the room around it, that serves an aim best."""

from clerestory.design.plan import Design, read_design
from clerestory.design.run import Found, run_design

__all__ = ["Design", "Found", "read_design", "run_design"]
