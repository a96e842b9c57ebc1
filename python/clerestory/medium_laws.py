"""How index and absorption depend on the wavelength: the two laws that make a medium."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from clerestory.array_rules import known_keys, same_length, vector, wavelength_range
from clerestory.errors import ClerestoryError

LAWS = ("sellmeier", "cauchy", "polynomial", "tabulated")


@dataclass(frozen=True)
class Dispersion:
    """How the refractive index depends on the wavelength.

    Parameters
    ----------
    law : {"sellmeier", "cauchy", "polynomial", "tabulated"}
        The formula (theory/media.md, eqs. 2 to 4), or measured values with straight lines between them.
    coefficients : tuple of float
        In the formula's order, wavelengths in µm; of a table λ₁ [nm], n₁, λ₂ [nm], n₂ …
    wavelength_range_nm : tuple of two floats, optional [nm]
        Where it holds; a table knows by itself.
    """

    law: Literal["sellmeier", "cauchy", "polynomial", "tabulated"]
    coefficients: tuple[float, ...]
    wavelength_range_nm: tuple[float, float] | None = None

    def __post_init__(self) -> None:
        if self.law not in LAWS:
            known = ", ".join(LAWS)
            raise ClerestoryError(f"law must be one of {known}, got {self.law!r}; give a constant n as a number")
        object.__setattr__(self, "coefficients", vector("coefficients", self.coefficients))
        object.__setattr__(self, "wavelength_range_nm", wavelength_range(self.wavelength_range_nm))

    def to_dict(self) -> dict[str, Any]:
        """Plain values for TOML or JSON."""
        range_nm = {} if self.wavelength_range_nm is None else {"wavelength_range_nm": list(self.wavelength_range_nm)}
        return {"law": self.law, "coefficients": list(self.coefficients)} | range_nm

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Dispersion:
        """The law of :meth:`to_dict`'s values; ClerestoryError for a key unknown or missing."""
        known_keys("n", values, {"law", "coefficients", "wavelength_range_nm"}, {"law", "coefficients"})
        return cls(**values)


@dataclass(frozen=True)
class AbsorptionSpectrum:
    """Absorption measured at some wavelengths, straight lines in between.

    Parameters
    ----------
    quantity : {"per_mm", "extinction"}
        The absorption coefficient α of the power [1/mm], or the extinction coefficient k, α = 4πk/λ
        (theory/media.md, eq. 6).
    wavelength_nm : tuple of float, increasing [nm]
    values : tuple of float, as many, at least 0
    """

    quantity: Literal["per_mm", "extinction"]
    wavelength_nm: tuple[float, ...]
    values: tuple[float, ...]

    def __post_init__(self) -> None:
        if self.quantity not in ("per_mm", "extinction"):
            raise ClerestoryError(f"quantity must be per_mm or extinction, got {self.quantity!r}; choose one")
        object.__setattr__(self, "wavelength_nm", vector("wavelength_nm", self.wavelength_nm))
        object.__setattr__(self, "values", vector("values", self.values))
        same_length("values", self.values, self.wavelength_nm)

    @property
    def pairs(self) -> tuple[float, ...]:
        """λ₁ [nm], value₁, λ₂, value₂ …"""
        return tuple(x for pair in zip(self.wavelength_nm, self.values, strict=True) for x in pair)

    def to_dict(self) -> dict[str, Any]:
        """Plain values for TOML or JSON."""
        return {"quantity": self.quantity, "wavelength_nm": list(self.wavelength_nm), "values": list(self.values)}

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> AbsorptionSpectrum:
        """The spectrum of :meth:`to_dict`'s values; ClerestoryError for a key unknown or missing."""
        keys = {"quantity", "wavelength_nm", "values"}
        known_keys("absorption_per_mm", values, keys, keys)
        return cls(**values)
