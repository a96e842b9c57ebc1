"""The Room view: scenes, the sun's way, light that refines while one looks."""
