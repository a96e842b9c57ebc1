"""Hypothesis strategies: panels that can be made, directions that can be met."""

from __future__ import annotations

from hypothesis import strategies as st

from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel, Pane, PrismaticPanel


def lengths(low, high):
    """Lengths [mm]."""
    return st.floats(low, high, allow_subnormal=False)


media = st.builds(Medium, n=st.floats(1.2, 2.0), absorption_per_mm=st.sampled_from([0.0, 0.003, 0.05]))
panes = st.builds(Pane, thickness_mm=lengths(0.5, 30.0), medium=media)
prismatic = st.builds(
    PrismaticPanel,
    pitch_mm=lengths(0.1, 10.0),
    lower_deg=st.floats(10.0, 80.0),
    upper_deg=st.floats(10.0, 80.0),
    base_mm=lengths(0.1, 10.0),
    ridges=st.sampled_from(["front", "back"]),
    medium=media,
)
#: Cuts of no width, tilted or not.
ideal_cuts = st.builds(
    LaserCutPanel,
    spacing_mm=lengths(1.0, 10.0),
    thickness_mm=lengths(1.0, 12.0),
    cut_tilt_deg=st.sampled_from([0.0, 0.0, 7.0, -20.0]),
    medium=media,
)
#: Cuts with a width. Without absorption, light between their walls at a slant takes seconds: theirs absorbs.
kerfs = st.builds(
    LaserCutPanel,
    spacing_mm=lengths(2.0, 10.0),
    thickness_mm=lengths(1.0, 10.0),
    cut_width_mm=lengths(0.05, 1.0),
    cut_tilt_deg=st.sampled_from([0.0, 10.0, -15.0]),
    medium=st.builds(Medium, n=st.floats(1.42, 2.0), absorption_per_mm=st.just(0.05)),
)
panels = st.one_of(panes, prismatic, ideal_cuts, kerfs)
incidences = st.fixed_dictionaries(
    {
        "elevation_deg": st.floats(-89.0, 89.0),
        "azimuth_deg": st.one_of(st.just(0.0), st.floats(-89.0, 89.0)),
        "side": st.sampled_from(["front", "back"]),
    }
)
polarisations = st.sampled_from(["resolved", "averaged"])
