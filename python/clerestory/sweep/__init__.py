"""Parameter studies: many independent cases, on one machine or on many."""

from clerestory.sweep.gather import as_grid, gather
from clerestory.sweep.plan import Sweep, read_sweep
from clerestory.sweep.run import Tally, run_sweep

__all__ = ["Sweep", "Tally", "as_grid", "gather", "read_sweep", "run_sweep"]
