"""What lies between two layers of a window."""

from __future__ import annotations

from dataclasses import dataclass

from clerestory.rules import one_of, positive

#: Gases by name; optically all are air.
GASES = ("air", "argon", "krypton", "xenon")


@dataclass(frozen=True, kw_only=True)
class Gap:
    """A space filled with gas between two layers of a :class:`~clerestory.Stack`.

    Light does not notice it: layers are wide, and every gas has the index of air to 3e-4. Width and gas are kept for
    programs that compute heat.

    Parameters
    ----------
    width_mm : float, greater than 0 [mm]
    gas : {"air", "argon", "krypton", "xenon"}, default "air"

    Raises
    ------
    ClerestoryError
        If the width is not above 0 or the gas is another.
    """

    width_mm: float
    gas: str = "air"

    def __post_init__(self) -> None:
        object.__setattr__(self, "width_mm", positive("width_mm", self.width_mm))
        one_of("gas", self.gas, GASES)
