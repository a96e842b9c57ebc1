"""How an opaque surface reflects."""

from __future__ import annotations

from dataclasses import dataclass

from clerestory import _native
from clerestory.errors import ClerestoryError
from clerestory.rules import within


@dataclass(frozen=True, kw_only=True)
class Material:
    """How an opaque surface reflects, the same on both sides.

    Parameters
    ----------
    diffuse_reflectance : float, 0..1
        Share of the light sent out evenly in all directions (Lambert).
    specular_reflectance : float, 0..1, default 0
        Share mirrored, as by a light shelf or pipe. Both together at most 1.
    """

    diffuse_reflectance: float
    specular_reflectance: float = 0.0

    def __post_init__(self) -> None:
        diffuse = within("diffuse_reflectance", self.diffuse_reflectance, 0.0, 1.0)
        specular = within("specular_reflectance", self.specular_reflectance, 0.0, 1.0)
        if diffuse + specular > 1.0 + 1e-12:
            raise ClerestoryError(
                f"diffuse_reflectance + specular_reflectance must be at most 1, got {diffuse:g} + {specular:g}"
            )
        object.__setattr__(self, "diffuse_reflectance", diffuse)
        object.__setattr__(self, "specular_reflectance", specular)

    def native(self) -> _native.Material:
        """The compiled half."""
        return _native.Material(self.diffuse_reflectance, self.specular_reflectance)


def as_material(name: str, value: Material | float) -> Material:
    """A material, or one of a given diffuse reflectance."""
    if isinstance(value, Material):
        return value
    return Material(diffuse_reflectance=within(f"{name} reflectance", value, 0.0, 1.0))
