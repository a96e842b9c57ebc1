"""The pictures of a year report, each with the words that stand for it where it cannot be seen."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from clerestory.glazing import Stack
from clerestory.panels.panel import Panel
from clerestory.year.figures import FIGURES, value_of
from clerestory.year.study import YearStudy

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BEAM_ELEVATION_DEG = 50.0
"""Of the sunlight in the pictures of panels."""

SHARES = (
    "mean_daylight_autonomy",
    "mean_continuous_daylight_autonomy",
    "mean_useful_autonomous",
    "mean_useful_exceeded",
    "spatial_daylight_autonomy",
    "annual_sunlight_exposure",
    "lighting_saved_percent",
)
"""Figures that share one axis."""

DPI = 130


@dataclass(frozen=True)
class Picture:
    """A picture of the report.

    Parameters
    ----------
    name : str
        Of its file.
    source : str
        The picture itself, as a data address.
    alt, caption : str
        What it shows, in words; and what stands under it.
    wide : bool
        Whether it takes the page's width.
    """

    name: str
    source: str
    alt: str
    caption: str
    wide: bool = True


def comparison(results: Mapping[str, xr.Dataset]) -> Picture:
    """The shares of all variants on one axis."""
    from clerestory.plots.variant_dots import variant_dots

    rows: dict[str, dict[str, tuple[float, float]]] = {}
    for figure in FIGURES:
        if figure.name in SHARES:
            pairs = {label: value_of(found, figure) for label, found in results.items()}
            known = {label: (pair[0], np.nan_to_num(pair[1])) for label, pair in pairs.items() if pair is not None}
            if known:
                rows["Electricity saved" if figure.name == "lighting_saved_percent" else figure.label] = known
    words = "; ".join(
        f"{name}: " + ", ".join(f"{label} {value:.0f} %" for label, (value, _) in row.items())
        for name, row in rows.items()
    )
    return _picture(
        "comparison",
        variant_dots(rows),
        alt=f"Dots of the variants on a line for each figure. {words}.",
        caption="The variants side by side, with one standard error.",
        form="svg",
    )


def sections(study: YearStudy, results: Mapping[str, xr.Dataset]) -> Iterator[Picture]:
    """Daylight autonomy and illuminance from the window to the back of the room."""
    from clerestory.plots.room_section import room_section

    room = next(iter(study.variants.values()))
    for name, threshold, what in (
        ("daylight_autonomy", study.measures.depth_percent, "daylight autonomy"),
        ("daylight_factor", None, "daylight factor"),
    ):
        curves = {label: grid for label, found in results.items() if (grid := first_grid(found[name])) is not None}
        if not curves:
            continue
        errors = {}
        if f"{name}_standard_error" in next(iter(results.values())):
            errors = {
                label: error
                for label, found in results.items()
                if (error := first_grid(found[f"{name}_standard_error"])) is not None
            }
        ends = "; ".join(
            f"{label} {float(_row(curve, 0)):.0f} % in the first row and {float(_row(curve, -1)):.1f} % in the last"
            for label, curve in curves.items()
        )
        yield _picture(
            f"section-{name.replace('_', '-')}",
            room_section(curves, room=room, standard_errors=errors, threshold=threshold),
            alt=f"Curves of {what} against the distance into the room: {ends}.",
            caption=f"{what.capitalize()} from the window wall to the back of the room.",
            form="svg",
            wide=False,
        )


def plans(study: YearStudy, results: Mapping[str, xr.Dataset]) -> Iterator[Picture]:
    """Plans of the metrics that differ over the room."""
    from clerestory.plots.metric_plans import metric_plans

    room = next(iter(study.variants.values()))
    asked: list[tuple[str, Any, str, float | None]] = [
        ("daylight_autonomy", None, "Daylight autonomy", study.measures.depth_percent),
        ("useful_daylight_illuminance", "autonomous", "Useful daylight, autonomous band", None),
        ("sunlit_hours", None, "Hours with direct sun, blinds open", study.measures.exposure_limit_h),
        ("glare_prone_hours", None, "Hours in the direct or redirected sun's patch, blinds open", None),
    ]
    for name, band, what, level in asked:
        drawn = {}
        for label, found in results.items():
            values = found[name] if band is None else found[name].sel(band=band, drop=True)
            grid = first_grid(values)
            if grid is not None:
                drawn[label] = grid.assign_attrs(long_name=what)
        if drawn:
            ends = "; ".join(
                f"{label} from {float(grid.min()):.0f} to {float(grid.max()):.0f}" for label, grid in drawn.items()
            )
            units = str(next(iter(drawn.values())).attrs["units"])
            unit = {"percent": "%"}.get(units, units)
            yield _picture(
                f"plan-{name.replace('_', '-')}",
                metric_plans(drawn, room=room, level=level),
                alt=f"Plans of the room, one a variant: {what.lower()} in {unit}: {ends}.",
                caption=f"{what}. The window lies at the bottom." + (f" Line: {level:g} {unit}." if level else ""),
            )


def carpets(results: Mapping[str, xr.Dataset]) -> Iterator[Picture]:
    """The hours of the year."""
    from clerestory.plots.carpet import carpet

    for name, what in (("mean_illuminance", "Mean"), ("least_illuminance", "Least")):
        series = {label: found[name] for label, found in results.items()}
        means = "; ".join(
            f"{label} {float(values.where(found['in_use']).mean()):.0f} lx"
            for (label, values), found in zip(series.items(), results.values(), strict=True)
        )
        yield _picture(
            f"carpet-{name.replace('_', '-')}",
            carpet(series),
            alt=f"Carpets of the year, days across and hours up. {what} illuminance, averaged over the hours of use: "
            f"{means}.",
            caption=f"{what} illuminance of the work plane hour by hour, on the wall clock; black is night.",
        )


def beams(study: YearStudy) -> Iterator[Picture]:
    """Each panel cut open, with sunlight going through."""
    from clerestory.panels.section_beams import section_beams
    from clerestory.plots.section import section

    seen: list[Panel] = []
    for label, room in study.variants.items():
        for window in room.windows:
            for panel in _panels(window.glazing):
                if panel in seen:
                    continue
                seen.append(panel)
                table = panel.angular(elevation_deg=[BEAM_ELEVATION_DEG]).isel(elevation=0, azimuth=0)
                shares = {name: 100.0 * float(table[f"transmittance_{name}"]) for name in ("deflected", "undeflected")}
                back = 100.0 * float(table["reflectance"]) if "reflectance" in table else float("nan")
                yield _picture(
                    f"beams-{len(seen)}",
                    section(panel, section_beams(panel, elevation_deg=BEAM_ELEVATION_DEG)),
                    alt=f"Section of the panel of “{label}”, the outside to the left. Of sunlight from "
                    f"{BEAM_ELEVATION_DEG:g}° above, {shares['deflected']:.0f} % leaves upwards into the room, "
                    f"{shares['undeflected']:.0f} % downwards"
                    + ("." if np.isnan(back) else f", and {back:.0f} % goes back."),
                    caption=f"The panel of “{label}” in {window.name}, "
                    f"with sunlight from {BEAM_ELEVATION_DEG:g}° above.",
                    wide=False,
                )


def first_grid(values: xr.DataArray) -> xr.DataArray | None:
    """The sensors of the first group that is a grid of at least 2 by 2."""
    for group in dict.fromkeys(values["group"].values.tolist()):
        one = values.isel(sensor=np.flatnonzero(values["group"].values == group))
        if min(len(np.unique(one["row"])), len(np.unique(one["column"]))) > 1:
            return one
    return None


def _row(values: xr.DataArray, which: int) -> xr.DataArray:
    rows = np.unique(values["row"].values)
    return values.isel(sensor=np.flatnonzero(values["row"].values == rows[which])).mean()


def _panels(glazing: Any) -> Iterator[Panel]:
    if isinstance(glazing, Panel):
        yield glazing
    elif isinstance(glazing, Stack):
        for layer in glazing.layers:
            yield from _panels(layer)


def _picture(name: str, figure: Figure, *, alt: str, caption: str, form: str = "png", wide: bool = True) -> Picture:
    drawn = io.BytesIO()
    if form == "svg":
        figure.savefig(drawn, format="svg", metadata={"Date": None})
    else:
        figure.savefig(drawn, format="png", dpi=DPI)
    kind = "image/svg+xml" if form == "svg" else "image/png"
    source = f"data:{kind};base64,{base64.b64encode(drawn.getvalue()).decode()}"
    return Picture(name=name, source=source, alt=alt, caption=caption, wide=wide)
