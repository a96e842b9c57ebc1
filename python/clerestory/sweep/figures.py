"""What a study comes down to: one row a case."""

from __future__ import annotations

from typing import Any

import xarray as xr

INPUTS = ("key", "status")


def figures_of(gathered: xr.Dataset) -> xr.Dataset:
    """The figures of each case that are single numbers, over ``case`` alone.

    Parameters
    ----------
    gathered : Dataset of `gather`

    Returns
    -------
    Dataset, dims ("case",)
        Figures over ``case`` and one or two short dimensions (a variant, a sky) have a name for each, as
        ``illuminance_mean (glass, overcast)``.
    """
    flat: dict[str, Any] = {}
    for name in gathered.data_vars:
        values = gathered[name]
        over = [dim for dim in values.dims if dim != "case"]
        if "case" not in values.dims or not set(over) <= {"variant", "sky"} or values.dtype.kind not in "fiub":
            continue
        if not over:
            flat[str(name)] = values
            continue
        stacked = values.stack(label=over)
        alone = all(gathered.sizes[dim] == 1 for dim in over)
        for place in range(stacked.sizes["label"]):
            one = stacked.isel(label=place)
            label = ", ".join(str(one[dim].item()) for dim in over)
            bare = one.drop_vars(["label", *over], errors="ignore")
            flat[str(name) if alone else f"{name} ({label})"] = bare
    return xr.Dataset(flat, attrs=gathered.attrs)
