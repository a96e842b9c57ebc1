"""A BSDF as a glazing: evaluated, summed and drawn from across the border of the compiled half."""

import numpy as np
import pytest

from clerestory import ClerestoryError, _native


def test_klems_bases_are_those_of_lbnl() -> None:
    for name, patches in [("klems_full", 145), ("klems_half", 77), ("klems_quarter", 41)]:
        basis = _native.KlemsBasis(name)
        assert len(basis) == patches == sum(basis.counts)
        assert basis.projected_solid_angle.sum() == pytest.approx(np.pi, abs=1e-13)
        assert basis.find(basis.centres[:, :2]).tolist() == list(range(patches))
        again = _native.KlemsBasis.of_rings(name, basis.theta_bounds_deg[:, 0].round(6).tolist(), basis.counts)
        assert np.allclose(again.solid_angle, basis.solid_angle, rtol=1e-13)
    with pytest.raises(ClerestoryError, match="basis must be one of klems_full"):
        _native.KlemsBasis("klems")


def test_a_matrix_sends_an_incident_patch_where_its_column_says() -> None:
    basis = _native.KlemsBasis("klems_full")
    values = np.zeros((145, 145))
    values[7, 40] = 0.25 / basis.projected_solid_angle[7]
    glazing = _native.Glazing.bsdf_matrix("klems_full", basis, values, None, None, None)
    incident, outgoing = basis.centres[[40]], basis.centres[[7]]
    assert glazing.spreads
    assert glazing.bsdf(incident, outgoing)[0] == pytest.approx(values[7, 40])
    assert glazing.spread(incident)[0] == pytest.approx(0.25)
    # swapped, mirrored to the other side, or from the back: nothing
    mirrored = np.array([1.0, 1.0, -1.0])
    assert not glazing.bsdf(
        np.vstack([outgoing, incident, -incident]), np.vstack([incident, outgoing * mirrored, outgoing])
    ).any()
    drawn = glazing.scatter(np.repeat(incident, 20_000, axis=0), 3)
    leaves = drawn[np.isfinite(drawn[:, 0])]
    assert set(basis.find(leaves[:, :2])) == {7}
    assert (leaves[:, 2] > 0).all()
    assert abs(len(leaves) / len(drawn) - 0.25) < 4 * np.sqrt(0.25 * 0.75 / len(drawn))


def test_broken_blocks_are_refused_with_the_reason() -> None:
    with pytest.raises(ClerestoryError, match="145 outgoing by 145 incident"):
        _native.Glazing.bsdf_matrix("klems_full", "klems_full", np.zeros((41, 41)), None, None, None)
    with pytest.raises(ClerestoryError, match=r"transmission_front must send out no more than 1\.01"):
        _native.Glazing.bsdf_matrix("klems_quarter", "klems_quarter", np.full((41, 41), 0.4), None, None, None)
    with pytest.raises(ClerestoryError, match="finite and 0 or more"):
        _native.Glazing.bsdf_tree(4, None, np.array([-0.1]), None, None)
    with pytest.raises(ClerestoryError, match="children for every node"):
        _native.Glazing.bsdf_tree(3, np.array([np.nan, 0.1]), None, None, None)
