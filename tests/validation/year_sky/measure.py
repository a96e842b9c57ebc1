"""Sky matrices of a year by both programs."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from pvlib import irradiance
from tests.validation.claim import Claim, Measured
from tests.validation.year_sky.radiance import RadianceYear, radiance_year

from clerestory import Weather, read_epw, sky_basis, sky_matrix, sun_normal_illuminance_lx
from clerestory.plots.style import COLOURS, blank, styled
from clerestory.sky.perez import diffuse_efficacy_lm_w, luminance_parameters, sky_conditions
from clerestory.sunlight import relative_air_mass

Array = NDArray[np.float64]

EPW = Path(__file__).parents[3] / "examples" / "classroom" / "USA_FL_Miami.Intl.AP.722020_TMY3.epw"
HIGHEST_DEG = 87.0


def as_radiance(weather: Weather, theirs: RadianceYear) -> Array:
    """Luminances of the centres with gendaymtx's suns and its readings of the models, (patch, time)."""
    altitude = np.degrees(np.arcsin(np.clip(theirs.sun[:, 2], -1.0, 1.0)))
    seen = np.clip(altitude, 0.0, HIGHEST_DEG)
    # F. Kasten, 1966, where relative_air_mass is F. Kasten and A. T. Young, 1989
    kasten = 1.0 / (np.sin(np.radians(seen)) + 0.15 * (93.885 - (90.0 - seen)) ** -1.253)
    outside = irradiance.get_extra_radiation(np.arange(len(weather)) // 24 + 1, solar_constant=1367.0, method="spencer")
    direct, diffuse = (
        weather.frame[f"{name}_irradiance_w_m2"].to_numpy() for name in ("direct_normal", "diffuse_horizontal")
    )
    conditions = sky_conditions(
        direct_normal_irradiance_w_m2=direct,
        diffuse_horizontal_irradiance_w_m2=diffuse,
        sun_altitude_deg=seen,
        extraterrestrial_irradiance_w_m2=np.asarray(outside) * relative_air_mass(seen) / kasten,
    )
    dew_point = weather.frame.dew_point_c.to_numpy()
    three_hours = np.convolve(np.concatenate([dew_point[:1], dew_point[:1], dew_point]), np.full(3, 1.0 / 3.0), "valid")
    azimuth = np.arctan2(theirs.sun[:, 0], theirs.sun[:, 1])
    level = np.cos(np.radians(seen))
    sun = np.stack([level * np.sin(azimuth), level * np.cos(azimuth), np.sin(np.radians(seen))], axis=1)
    horizontal = diffuse * diffuse_efficacy_lm_w(conditions, dew_point_c=three_hours)
    values = sky_basis("tregenza145").all_weather(luminance_parameters(conditions), sun, horizontal, 0)
    return values.T.astype(np.float64)[:-1]


def claim(thorough: bool) -> Claim:
    """Patch by patch and hour by hour, the same every time."""
    weather = read_epw(EPW)
    theirs = radiance_year(EPW, hours=len(weather))
    lit = (weather.frame.diffuse_horizontal_irradiance_w_m2.to_numpy() > 0.0) & (theirs.sun[:, 2] > 0.0)
    known = theirs.luminance[:-1, lit]
    same = np.abs(as_radiance(weather, theirs)[:, lit] / known - 1.0)
    usual = sky_matrix(weather, "tregenza145").values[:-1, lit].astype(np.float64)
    sums = usual.sum(axis=1) / known.sum(axis=1) - 1.0
    sun = float(sun_normal_illuminance_lx(weather).sum()) / theirs.sun_lx.sum() - 1.0
    centres = sky_matrix(weather, "tregenza145", sampling="centre").values[:-1, lit]
    with styled():
        figure = blank(6.4, 4.0)
        axes = figure.add_subplot()
        places = np.linspace(0.0, 100.0, 400)
        kinds = {
            "its suns, centres of patches": same,
            "exact suns, centres of patches": np.abs(centres / known - 1.0),
            "exact suns, means over patches": np.abs(usual / known - 1.0),
        }
        for (label, values), colour in zip(kinds.items(), COLOURS, strict=False):
            axes.plot(100.0 * np.percentile(values, places), places, color=colour, label=label)
        axes.set(
            xscale="log",
            xlim=(1e-5, 100.0),
            xlabel="Difference from gendaymtx [%], at most",
            ylabel="Patches and hours [%]",
            title="145 patches, every lit hour of Miami",
        )
        axes.legend(loc="center left", bbox_to_anchor=(0.14, 0.45))
    return Claim(
        [
            Measured("its suns, centres: greatest relative difference of a patch in an hour", float(same.max()), 1e-3),
            Measured(
                "exact suns, means: annual sum of a patch, greatest relative difference",
                float(np.abs(sums).max()),
                0.02,
            ),
            Measured(
                "exact suns, means: annual sums of patches, rms relative difference",
                float(np.sqrt(np.mean(sums**2))),
                0.01,
            ),
            Measured("illuminance of the sun, annual sum, relative difference", abs(sun), 0.005),
            Measured("hours compared", float(lit.sum()), 4000.0, is_floor=True),
        ],
        figure,
    )
