"""The blinds rule, counted by hand."""

import numpy as np
import pytest
import xarray as xr
from tests.metrics.years import year

from clerestory.errors import ClerestoryError
from clerestory.metrics import blinds_closed, with_blinds


def group(sky, direct, redirected, interreflected):
    parts = {"sky": sky, "sun_direct": direct, "sun_redirected": redirected, "sun_interreflected": interreflected}
    found = xr.Dataset({name: year(rows) for name, rows in parts.items()})
    return found.assign(total=sum(found[name] for name in parts))


def test_more_than_two_percent_of_the_sensors_close_the_blinds():
    sun = np.zeros((100, 4))
    sun[:2, 1], sun[:3, 2], sun[:50, 3] = 1000.0, 1000.0, 999.0
    # 2 of 100 are not more than 2 %, 3 are; 999 lx is no sun
    assert blinds_closed(year(sun)).values.tolist() == [False, False, True, False]


def test_closed_blinds_keep_the_beam_out_and_thin_the_rest():
    view = group([[400.0, 400.0]], [[0.0, 2000.0]], [[0.0, 30.0]], [[50.0, 100.0]])
    upper = group([[100.0, 100.0]], [[0.0, 0.0]], [[500.0, 500.0]], [[10.0, 20.0]])
    found = with_blinds({"view": view, "upper": upper}, transmittance={"view": 0.2})
    assert found.blinds_closed.sel(window_group="view").values.tolist() == [False, True]
    assert found.total.values.tolist() == [[450.0 + 610.0, 0.2 * 500.0 + 620.0]]
    assert found.sun_direct.values.tolist() == [[0.0, 0.0]]
    assert found.sizes["window_group"] == 1


def test_each_group_is_judged_by_its_own_sun():
    # half of the room is sunlit, by two groups that each light none of it alone
    low = group([[0.0]], [[600.0]], [[0.0]], [[0.0]])
    found = with_blinds({"left": low, "right": low})
    assert not found.blinds_closed.any()
    assert found.total.values.tolist() == [[1200.0]]


def test_without_blinds_nothing_changes():
    lit = group([[400.0]], [[2000.0]], [[30.0]], [[100.0]])
    found = with_blinds({"all": lit}, transmittance={})
    assert found.total.values.tolist() == lit.total.values.tolist()
    assert "blinds_closed" not in found


def test_wrong_blinds_are_told():
    lit = group([[400.0]], [[2000.0]], [[30.0]], [[100.0]])
    with pytest.raises(ClerestoryError, match=r"must name groups \(view\), got 'vew'"):
        with_blinds({"view": lit}, transmittance={"vew": 0.2})
    with pytest.raises(ClerestoryError, match=r"blinds of 'view' must lie in 0..1, got 20"):
        with_blinds({"view": lit}, transmittance=20)
    with pytest.raises(ClerestoryError, match="at least one group"):
        with_blinds({})
