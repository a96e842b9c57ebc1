"""The BSDF view: anybody's files, the discs of panels, files for other programs."""
