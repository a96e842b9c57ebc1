"""The Year view: carpets of hours, years that are run from a file."""
