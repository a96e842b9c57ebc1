"""How well a computed table agrees with another or with a measurement."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from clerestory.errors import ClerestoryError
from clerestory.measured import QUANTITIES, read_measured

if TYPE_CHECKING:
    import xarray as xr

Floats = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Comparison:
    """Computed values against reference values of one quantity, point by point.

    Attributes
    ----------
    quantity : str
    n : int
        Points compared.
    r_squared : float
        Coefficient of determination of the straight line fitted to computed (ordinate) over reference (abscissa)
        values; nan if either does not vary.
    slope, intercept : float
        Of that line; agreement is 1 and 0.
    rms : float
        Root of the mean square of computed - reference.
    largest_difference : float
        Of the computed less the reference, with its sign; ``largest_at_elevation_deg`` says where.
    values, reference, elevation_deg : ndarrays, shape (n,)
        The computed and the reference values.

    Notes
    -----
    Least squares: slope = cov(x, y) / var(x), R² = cov(x, y)² / (var(x) var(y)).
    """

    quantity: str
    n: int
    r_squared: float
    slope: float
    intercept: float
    rms: float
    largest_difference: float
    largest_at_elevation_deg: float
    values: Floats = field(repr=False)
    reference: Floats = field(repr=False)
    elevation_deg: Floats = field(repr=False)

    def to_dict(self) -> dict[str, Any]:
        """The numbers, without the points, for JSON."""
        points = ("values", "reference", "elevation_deg")
        values = {name: getattr(self, name) for name in self.__dataclass_fields__ if name not in points}
        return {name: None if value != value else value for name, value in values.items()}


def compare(table: xr.Dataset, reference: str | os.PathLike[str] | xr.Dataset | xr.DataArray) -> dict[str, Comparison]:
    """How well a table agrees with a measurement or another table.

    Parameters
    ----------
    table : Dataset
        Of :meth:`Panel.angular <clerestory.Panel.angular>`, of one wavelength or of daylight. Between its elevations
        and azimuths straight lines are drawn: compute it at those of the reference where that matters.
    reference : path, Dataset or DataArray
        A CSV file (:func:`read_measured` says what must be in it), what that function returns, another table, or one of
        a table's variables.

    Returns
    -------
    dict of str to Comparison
        One for each quantity that both hold, in the order of the reference.

    Raises
    ------
    ClerestoryError
        If they share no quantity, fewer than two points can be compared, or the reference has points beyond the
        table's.
    """
    points = _points(reference)
    if "wavelength" in table.dims:
        raise ClerestoryError("the table must be of one wavelength, got several; choose one with .sel(wavelength=…)")
    shared = [str(name) for name in points.data_vars if name in QUANTITIES and name in table]
    if not shared:
        raise ClerestoryError(
            f"reference must hold a quantity of the table ({', '.join(map(str, table.data_vars))}), "
            f"got {', '.join(map(str, points.data_vars))}; rename its columns"
        )
    elevation = points["elevation_deg"].values
    at = {"elevation": points["elevation_deg"], "azimuth": points["azimuth_deg"]}
    for name, wanted in at.items():
        low, high = float(table[name].min()), float(table[name].max())
        beyond = wanted.values[(wanted.values < low) | (wanted.values > high)]
        if beyond.size:
            raise ClerestoryError(
                f"{name}_deg of the reference must lie within the table's ({low:g} to {high:g}), got {beyond[0]:g}; "
                "compute the table there too"
            )
    single = [name for name in at if table.sizes[name] == 1]
    flat = table[shared].sortby(list(at)).squeeze(single)
    found = flat.interp({name: wanted for name, wanted in at.items() if name not in single})
    return {
        name: regression(name, np.broadcast_to(found[name].values, elevation.shape), points[name].values, elevation)
        for name in shared
    }


def regression(quantity: str, computed: Floats, reference: Floats, elevation_deg: Floats) -> Comparison:
    """The comparison of two lists of values, shape (n,); points where either is nan are left out."""
    is_known = np.isfinite(computed) & np.isfinite(reference)
    x, y, elevation_deg = reference[is_known], computed[is_known], elevation_deg[is_known]
    if x.size < 2:
        raise ClerestoryError(f"{quantity} must be known at two points or more, got {x.size}; measure more")
    dx, dy = x - x.mean(), y - y.mean()
    vary = float(dx @ dx) > 0.0
    slope = float(dx @ dy) / float(dx @ dx) if vary else np.nan
    r_squared = float(dx @ dy) ** 2 / (float(dx @ dx) * float(dy @ dy)) if vary and float(dy @ dy) > 0.0 else np.nan
    difference = y - x
    worst = int(np.argmax(np.abs(difference)))
    return Comparison(
        quantity=quantity,
        n=int(x.size),
        r_squared=r_squared,
        slope=slope,
        intercept=float(y.mean() - slope * x.mean()),
        rms=float(np.sqrt(np.mean(difference**2))),
        largest_difference=float(difference[worst]),
        largest_at_elevation_deg=float(elevation_deg[worst]),
        values=y,
        reference=x,
        elevation_deg=elevation_deg,
    )


def _points(reference: Any) -> xr.Dataset:
    """The reference as a Dataset over ``point``."""
    import xarray as xr

    if isinstance(reference, (str, os.PathLike)):
        return read_measured(reference)
    if isinstance(reference, xr.DataArray):
        if reference.name not in QUANTITIES:
            known = ", ".join(QUANTITIES)
            raise ClerestoryError(f"reference must be named as a quantity ({known}), got {reference.name!r}; rename it")
        reference = reference.to_dataset()
    if isinstance(reference, xr.Dataset) and "elevation_deg" in reference:
        return reference
    if not isinstance(reference, xr.Dataset) or "elevation" not in reference.coords:
        kind = type(reference).__name__
        raise ClerestoryError(f"reference must be a CSV file or a table with the coordinate elevation, got a {kind}")
    if "azimuth" not in reference.coords:
        reference = reference.assign_coords(azimuth=0.0)
    names = {"elevation": "elevation_deg", "azimuth": "azimuth_deg"}
    # every point of the grid in a row, its angles beside it
    frame = reference.expand_dims([name for name in names if name not in reference.dims]).to_dataframe().reset_index()
    return xr.Dataset({names.get(str(name), str(name)): ("point", frame[name].to_numpy()) for name in frame.columns})
