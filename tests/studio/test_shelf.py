"""What is kept while it is looked at, and what leaves."""

import pytest

from clerestory.errors import ClerestoryError
from clerestory.studio.shelf import Shelf


def shelf(**limits: float) -> Shelf[str]:
    return Shelf(**{"most": 3, "gone": "key must be one: again", "size": len, **limits})  # type: ignore[arg-type]


def kept(one: Shelf[str]) -> str:
    return "".join(key for key in "abcdefgh" if one.find(key) is not None)


def test_the_one_looked_at_longest_ago_leaves_first() -> None:
    one = shelf()
    for key in "abc":
        one.put(key, key)
    assert one.get("a") == "a"
    one.put("d", "d")
    assert kept(one) == "acd"
    # to find is not to look; to place again is
    one.find("c")
    assert one.place("c", lambda: "new") == "c"
    one.find("a")
    one.put("e", "e")
    assert kept(one) == "cde"


def test_what_is_too_large_leaves_but_the_newest() -> None:
    one = shelf(most_bytes=10)
    one.put("a", "1234")
    one.put("b", "123456")
    assert kept(one) == "ab"
    one.put("c", "1")
    assert kept(one) == "bc"
    one.put("d", "1" * 99)
    assert kept(one) == "d"


def test_what_grows_on_the_shelf_is_weighed_again() -> None:
    one: Shelf[list[int]] = Shelf(9, "key", most_bytes=4, size=len)
    grown = one.place("a", list)
    one.place("b", list)
    grown += [1] * 5
    one.trim()
    assert one.find("a") is None
    assert one.find("b") == []


@pytest.mark.parametrize("key", ["none", "", None, 7, ["a"]])
def test_a_key_of_nothing_is_told(key: object) -> None:
    one = shelf()
    one.put("a", "a")
    assert one.find(key) is None
    with pytest.raises(ClerestoryError, match=r"^key must be one: again$"):
        one.get(key)
