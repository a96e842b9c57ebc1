"""What a reader or writer of BSDF files had to assume, as a warning."""


class BsdfWarning(UserWarning):
    """Something a file does not say, and what stands in for it."""
