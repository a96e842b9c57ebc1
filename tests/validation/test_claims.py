"""Every claim of docs/validation.md stands, tried on fewer panels and directions than the page."""

import re

import pytest
from tests.validation.cases import CASES, FOLDER, claim

#: Packages that a case compares with; a machine without them leaves it out.
OTHER_PROGRAMS = {
    "radiance_room": ["pyradiance"],
    "radiance_bsdf_room": ["pyradiance"],
    "radiance_mirrors": ["pyradiance"],
    "layered_glazing": ["pywincalc"],
    "year_sky": ["pyradiance"],
    "year_radiance": ["pyradiance"],
}


@pytest.mark.parametrize("case", CASES)
def test_claim_stands(case):
    for program in OTHER_PROGRAMS.get(case, ()):
        pytest.importorskip(program, reason="the other program")
    found = claim(case, thorough=False)
    failed = [measured.row for measured in found.measured if not measured.holds]
    assert found.measured
    assert not failed, "\n".join(failed)
    assert found.figure.axes


def test_every_case_is_on_the_page_and_says_what_it_asks():
    folders = {path.parent.name for path in FOLDER.glob("*/measure.py")}
    assert folders == set(CASES)
    for case in CASES:
        text = (FOLDER / case / "README.md").read_text(encoding="utf-8")
        assert re.match(r"# .+\n\n\*\*Question\.\*\* ", text), case
        assert "\n\n**Source.** " in text, case
        assert "\n\n**Tolerance.** " in text, case
