"""What a study of a year takes for granted, in words."""

from __future__ import annotations

from collections.abc import Mapping

import xarray as xr

from clerestory.metrics.schedule import ANALYSIS_HOURS
from clerestory.room.scene import Room
from clerestory.year.measure import PLACEMENT
from clerestory.year.study import YearStudy
from clerestory.year.window_groups import groups_of


def assumptions(study: YearStudy) -> list[tuple[str, str]]:
    """Name and words of each assumption, those of the place first."""
    weather, site, how = study.weather, study.weather.site, study.calculation
    room = next(iter(study.variants.values()))
    rows = [
        (
            "Place",
            f"latitude {site.latitude_deg:g}°, longitude {site.longitude_deg:g}° (east positive), "
            f"{site.elevation_m:g} m, clock of {site.timezone}",
        ),
        (
            "Weather",
            f"{weather.source}; {len(weather)} intervals of {weather.interval_minutes:g} min, "
            "the sun in the middle of each",
        ),
    ]
    rows += [("Weather, note", note) for note in weather.notes]
    rows += [
        ("Sky", "Perez all-weather luminance (1993) and luminous efficacy (1990); the sun is kept apart from the sky"),
        ("Ground", f"even and unobstructed, reflectance {room.ground_reflectance:g}, lit by sky and sun"),
        ("Surfaces", _surfaces(room)),
        ("Hours of use", study.schedule.description),
        (
            "Analysis hours of sDA and ASE",
            ANALYSIS_HOURS.description.replace("standard time", f"clock of {site.timezone}"),
        ),
        ("Blinds", _blinds(study, room)),
    ]
    if study.lighting is not None:
        lamps = study.lighting
        rows.append(
            (
                "Electric lighting",
                f"{lamps.power_density_w_m2:g} W/m² for {lamps.setpoint_lx:g} lx; dimmed by the darkest sensor of each "
                f"{lamps.zone}, down to {100 * lamps.minimum_light_share:g} % of the light at "
                f"{100 * lamps.minimum_power_share:g} % of the power"
                + (", then switched off" if lamps.switched_off else ", then kept there"),
            )
        )
    measures = study.measures
    rows += [
        (
            "Thresholds",
            f"enough light {measures.threshold_lx:g} lx; bands of useful daylight at "
            f"{'/'.join(f'{limit:g}' for limit in measures.useful_limits_lx)} lx; direct sun from "
            f"{measures.sunlit_lx:g} lx; exposed beyond {measures.exposure_limit_h:g} h",
        ),
        (
            "Tracing",
            f"sky in {how.basis} patches, suns {how.suns}; {how.rounds} rounds of {how.nodes} nodes, seed {how.seed}",
        ),
    ]
    for label, one in study.variants.items():
        rows += [(f"Glazing, {label}", f"{window.name}: {window.glazing!r}") for window in one.windows]
    return rows


def errors_told(results: Mapping[str, xr.Dataset]) -> list[tuple[str, str]]:
    """How sure each variant is, in words."""
    rows = []
    for label, found in results.items():
        error = 100.0 * found["relative_standard_error"]
        words = (
            f"standard error of a sensor's light over the year: median {float(error.median()):.1f} %, "
            f"worst {float(error.max()):.1f} %"
        )
        if f"suns_{PLACEMENT[0]}" in found.attrs:
            worst, median, flips = (float(found.attrs[f"suns_{name}"]) for name in PLACEMENT)
            words += (
                f"; suns at the nearest of fewer places, at most {worst:.1f}° off: on a sample of hours the "
                f"sun's light of the room differs by {100 * median:.1f} % in the median hour, and {100 * flips:.1f} % "
                "of sensors are in the sun's beam in one and not in the other"
            )
        rows.append((label, words))
    return rows


def _surfaces(room: Room) -> str:
    by_material: dict[str, list[str]] = {}
    for surface in room.surfaces:
        material = surface.material
        words = f"{material.diffuse_reflectance:g} diffuse"
        if material.specular_reflectance:
            words += f" and {material.specular_reflectance:g} specular"
        by_material.setdefault(words, []).append(surface.name)
    return "reflectance " + "; ".join(f"{words}: {', '.join(names)}" for words, names in by_material.items())


def _blinds(study: YearStudy, room: Room) -> str:
    if not study.blinds:
        return "none"
    through = {one.name: one.transmittance for one in study.blinds}
    words = []
    for name, windows in groups_of(room, study.blinds).items():
        if name in through:
            words.append(
                f"{', '.join(windows)}: closed while the sun through them lights more than 2 % of the sensors with "
                f"{study.measures.sunlit_lx:g} lx; closed, {through[name]:g} of the diffuse light comes through "
                "and no beam"
            )
        else:
            words.append(f"{', '.join(windows)}: without blinds")
    return "; ".join(words)
