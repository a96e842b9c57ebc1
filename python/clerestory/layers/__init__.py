"""Layers one behind the other: gaps, how light divides among them, and what each of them keeps."""
