"""The studio: a local page that shows what the API computes (extra ``studio``)."""

from clerestory.studio.settings import Settings

__all__ = ["Settings"]
