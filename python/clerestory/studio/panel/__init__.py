"""The Panel view: sections, curves and discs of panels, drawn ones too, at once by rays and then exactly."""
