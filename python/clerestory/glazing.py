"""What may fill a window."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, runtime_checkable

from clerestory import _native
from clerestory.errors import ClerestoryError
from clerestory.rules import not_negative, positive, within


@runtime_checkable
class Glazing(Protocol):
    """Anything that may fill a window: a pane, a panel, a stack of them."""

    def glazing(self) -> _native.Glazing:
        """The compiled half, which the rays meet."""
        ...


@dataclass(frozen=True)
class Open:
    """An opening with nothing in it."""

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        return _native.Glazing.open()


@dataclass(frozen=True, kw_only=True)
class PlainTransmittance:
    """A sheet that lets the same share of light through at every angle, and reflects none.

    Parameters
    ----------
    transmittance : float, 0..1
    """

    transmittance: float

    def __post_init__(self) -> None:
        within("transmittance", self.transmittance, 0.0, 1.0)

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        return _native.Glazing.constant(self.transmittance)


@dataclass(frozen=True, kw_only=True)
class Glass:
    """A single pane of index 1.52 known by its transmittance at normal incidence, as Radiance's ``glass``.

    Parameters
    ----------
    transmittance : float, 0..0.9179
        At normal incidence, reflections between the faces included. A pane that absorbs nothing has 0.918.
    """

    transmittance: float

    def __post_init__(self) -> None:
        n = 1.52
        within("transmittance", self.transmittance, 0.0, 2.0 * n / (n * n + 1.0))

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        return _native.Glazing.glass(self.transmittance)


@dataclass(frozen=True)
class TregenzaSharples:
    """Clear 6 mm glass by the polynomial of Tregenza and Sharples; nothing is reflected."""

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        return _native.Glazing.tregenza_sharples()


@dataclass(frozen=True, kw_only=True)
class Slab:
    """A plane-parallel sheet with Fresnel's reflections at both faces and absorption on the way.

    Parameters
    ----------
    refractive_index : float, at least 1
    thickness_mm : float
    absorption_per_mm : float, default 0
    """

    refractive_index: float
    thickness_mm: float
    absorption_per_mm: float = 0.0

    def __post_init__(self) -> None:
        within("refractive_index", self.refractive_index, 1.0, 5.0)
        positive("thickness_mm", self.thickness_mm)
        not_negative("absorption_per_mm", self.absorption_per_mm)

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        return _native.Glazing.slab(self.refractive_index, self.thickness_mm, self.absorption_per_mm)


@dataclass(frozen=True)
class Stack:
    """Layers with air between them, such as a panel in a double window.

    Parameters
    ----------
    layers : sequence of Glazing
        From the outside to the room; light is followed back and forth between them.
    """

    layers: tuple[Glazing, ...]

    def __post_init__(self) -> None:
        layers = tuple(self.layers)
        if not layers:
            raise ClerestoryError("layers must hold at least one glazing, got none")
        for index, layer in enumerate(layers):
            check_glazing(f"layers[{index}]", layer)
        object.__setattr__(self, "layers", layers)

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        return _native.Glazing.stack([layer.glazing() for layer in self.layers])


def check_glazing(name: str, value: object) -> Glazing:
    """The value, if it can fill a window."""
    if not isinstance(value, Glazing) or isinstance(value, type):
        raise ClerestoryError(
            f"{name} must be a glazing such as Glass(transmittance=0.88) or LaserCutPanel(…), got {value!r}"
        )
    return value
