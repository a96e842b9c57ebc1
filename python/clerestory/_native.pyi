"""The compiled half of the package: what ``crates/python`` exposes."""

__version__: str
