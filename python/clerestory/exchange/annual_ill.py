"""A year of illuminance as text: month, day, hour, then a column for each sensor."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.exchange.clock_times import local_times
from clerestory.rules import one_of
from clerestory.saving import write_text


def write_ill(annual: xr.Dataset, path: str | os.PathLike[str], *, quantity: str = "total", decimals: int = 1) -> Path:
    """Writes a year of illuminance as Daysim does.

    Parameters
    ----------
    annual : Dataset of `annual_illuminance`, dims ("sensor", "time") [lx]
    path : path-like
        ``.ill``.
    quantity : str, default "total"
        Variable to write.
    decimals : int, 0..6, default 1
        Of the illuminance.

    Returns
    -------
    Path
        Of the file: a line for each time with month, day and hour (the middle of the interval in standard time),
        then the illuminance [lx] at each sensor, between spaces.

    Raises
    ------
    ClerestoryError
        If there is no such variable, a value is missing, or the file cannot be written.
    """
    values = illuminance_of(annual, quantity)
    times = local_times(annual)
    hours = times.hour + times.minute / 60.0 + times.second / 3600.0
    form = f"%.{int(decimals)}f"
    lines = [
        f"{month} {day} {hour:.3f} " + " ".join(form % value for value in row)
        for month, day, hour, row in zip(times.month, times.day, hours, values.T.tolist(), strict=True)
    ]
    return write_text(path, "\n".join(lines) + "\n")


def read_ill(path: str | os.PathLike[str], *, year: int = 2023) -> xr.DataArray:
    """A year of illuminance from such a file.

    Parameters
    ----------
    path : path-like
    year : int, default 2023
        Of the times, which the file leaves out.

    Returns
    -------
    DataArray, dims ("sensor", "time") [lx]

    Raises
    ------
    ClerestoryError
        If the file cannot be read, or a line is of another form; the message gives the line.
    """
    file = Path(path)
    try:
        text = file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as cause:
        raise ClerestoryError(f"{file} must be a readable text file, got: {cause}") from None
    rows: list[list[float]] = []
    times: list[pd.Timestamp] = []
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        try:
            month, day, hour, *values = (float(word) for word in line.split())
            start = pd.Timestamp(year=year, month=int(month), day=int(day))
        except ValueError:
            raise ClerestoryError(
                f"{file.name}, line {number}: must be month, day, hour and illuminances, got {line[:60]!r}"
            ) from None
        if not values or (rows and len(values) != len(rows[0])):
            raise ClerestoryError(
                f"{file.name}, line {number}: must have {len(rows[0]) if rows else 'some'} illuminances, "
                f"got {len(values)}"
            )
        rows.append(values)
        times.append(start + pd.Timedelta(hours=hour).round("s"))
    if not rows:
        raise ClerestoryError(f"{file.name} must hold at least one line, got none")
    return xr.DataArray(
        np.array(rows).T,
        dims=("sensor", "time"),
        coords={"sensor": np.arange(len(rows[0])), "time": pd.DatetimeIndex(times)},
        name="illuminance",
        attrs={"units": "lx", "source": file.name},
    )


def illuminance_of(annual: xr.Dataset, quantity: str) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    """A variable of a year's results, shape (sensor, time), none missing."""
    one_of("quantity", quantity, [str(name) for name in annual.data_vars if annual[name].dims == ("sensor", "time")])
    values = np.asarray(annual[quantity].values, dtype=np.float64)
    if not np.isfinite(values).all():
        sensor, hour = np.argwhere(~np.isfinite(values))[0]
        raise ClerestoryError(f"{quantity} must be finite to be written, got {values[sensor, hour]} at sensor {sensor}")
    return values
