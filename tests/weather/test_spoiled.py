"""Whatever befalls a weather file, it is read or refused in one line that names it."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from clerestory import ClerestoryError, read_epw, read_wea

from .conftest import HEADER_LINES, MIAMI

WORDS = ["9999", "-9999", "", "abc", "nan", "inf", "-inf", "1e9", "-5", "0", "25", "13", "é", " ", "2.5", "1e400"]
DAYS = 5


@pytest.fixture(scope="module")
def texts(miami):
    epw = MIAMI.read_text().splitlines()
    from clerestory.weather.wea import wea_text

    wea = wea_text(miami).splitlines()
    rows = slice(24 * 80, 24 * (80 + DAYS))
    return {
        ".epw": (epw[:HEADER_LINES] + epw[HEADER_LINES:][rows], ",", read_epw),
        ".wea": (wea[:6] + wea[6:][rows], " ", read_wea),
    }


CHANGE = st.tuples(
    st.sampled_from(["word", "word", "word", "cut", "drop", "swap"]),
    st.integers(0, 10_000),
    st.integers(0, 10_000),
    st.sampled_from(WORDS),
    st.booleans(),
)


def spoil(lines, separator, changes):
    found = list(lines)
    for kind, first, second, word, in_header in changes:
        at = first % min(len(found), HEADER_LINES) if in_header else first % len(found)
        if kind == "word":
            fields = found[at].split(separator)
            fields[second % len(fields)] = word
            found[at] = separator.join(fields)
        elif kind == "cut":
            found[at] = found[at][: second % (len(found[at]) + 1)]
        elif kind == "drop" and len(found) > 1:
            del found[at]
        else:
            other = second % len(found)
            found[at], found[other] = found[other], found[at]
    return "\n".join(found)


@pytest.mark.parametrize("ending", [".epw", ".wea"])
@settings(max_examples=60)
@given(changes=st.lists(CHANGE, min_size=1, max_size=4))
def test_spoiled_file_is_read_or_refused_in_one_line(ending, texts, tmp_path, changes):
    lines, separator, read = texts[ending]
    path = tmp_path / f"spoiled{ending}"
    path.write_text(spoil(lines, separator, changes), encoding="utf-8")
    try:
        table = read(path).frame
    except ClerestoryError as error:
        table, told = None, str(error)
    if table is None:
        assert str(path) in told
        assert "\n" not in told
    else:
        assert table.direct_normal_irradiance_w_m2.between(0.0, 1500.0).all()
        assert table.diffuse_horizontal_irradiance_w_m2.between(0.0, 1500.0).all()
