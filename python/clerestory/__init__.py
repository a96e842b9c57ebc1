"""Clerestory: design, characterise and simulate light-redirecting windows."""

from clerestory._native import __version__

__all__ = ["__version__"]
