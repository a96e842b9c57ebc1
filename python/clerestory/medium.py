"""What panes and panels are made of: refractive index and absorption, constant or over a spectrum."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from clerestory import _native
from clerestory.array_rules import known_keys, numbers, same_length, vector
from clerestory.elementwise import FloatOrArray, elementwise
from clerestory.errors import ClerestoryError
from clerestory.medium_laws import AbsorptionSpectrum, Dispersion
from clerestory.rules import number


@dataclass(frozen=True, repr=False)
class Medium:
    """A clear medium: refractive index and absorption.

    Parameters
    ----------
    n : float or Dispersion, default 1.49
        Refractive index relative to air, at least 1.
    absorption_per_mm : float or AbsorptionSpectrum, default 0
        Share of the power absorbed per mm of path, for short paths: α of Beer–Lambert, e^(−α·path) [1/mm].
    name : str, optional
        What to call it.

    Raises
    ------
    ClerestoryError
        If n is below 1 or not finite anywhere in its range, or the absorption negative or not finite.

    Notes
    -----
    Frozen and hashable. Named media and their sources: :meth:`named`. Theory: theory/media.md.

    Examples
    --------
    >>> Medium(n=1.49, absorption_per_mm=0.002).index()
    1.49
    >>> round(Medium.named("pmma").index(550.0), 5)
    1.49428
    """

    n: float | Dispersion = 1.49
    absorption_per_mm: float | AbsorptionSpectrum = 0.0
    name: str | None = None
    _laws: _native.Medium = field(init=False, compare=False)

    def __post_init__(self) -> None:
        if self.name is not None and not isinstance(self.name, str):
            raise ClerestoryError(f"name must be text, got {self.name!r}; put it in quotes or leave it out")
        if not isinstance(self.n, Dispersion):
            object.__setattr__(self, "n", number("n", self.n))
        if not isinstance(self.absorption_per_mm, AbsorptionSpectrum):
            object.__setattr__(self, "absorption_per_mm", number("absorption_per_mm", self.absorption_per_mm))
        n, alpha = self.n, self.absorption_per_mm
        if isinstance(n, Dispersion):
            law, coefficients, range_nm = str(n.law), n.coefficients, n.wavelength_range_nm
        else:
            law, coefficients, range_nm = "constant", (n,), None
        if isinstance(alpha, AbsorptionSpectrum):
            quantity, values = str(alpha.quantity), alpha.pairs
        else:
            quantity, values = "constant", (alpha,)
        object.__setattr__(self, "_laws", _native.Medium(law, coefficients, range_nm, quantity, values))

    def __reduce__(self) -> tuple[type[Medium], tuple[object, object, object]]:
        return Medium, (self.n, self.absorption_per_mm, self.name)

    def __repr__(self) -> str:
        if self._is_packaged():
            return f"Medium.named({self.name!r})"
        name = "" if self.name is None else f", name={self.name!r}"
        return f"Medium(n={self.n!r}, absorption_per_mm={self.absorption_per_mm!r}{name})"

    @classmethod
    def cauchy(
        cls,
        a: float,
        b_um2: float,
        c_um4: float = 0.0,
        *,
        wavelength_range_nm: tuple[float, float],
        absorption_per_mm: float | AbsorptionSpectrum = 0.0,
        name: str | None = None,
    ) -> Medium:
        """A medium of Cauchy's law, n = A + B/λ² + C/λ⁴, λ in µm (theory/media.md, eq. 3).

        Parameters
        ----------
        a, b_um2, c_um4 : float
            A [1], B [µm²] and C [µm⁴].
        wavelength_range_nm : tuple of two floats [nm]
            Where the law holds; outside it is an error.
        absorption_per_mm, name
            As of :class:`Medium`.

        Raises
        ------
        ClerestoryError
            If n falls below 1 in the range, or the range is empty.
        """
        coefficients = (a, b_um2, -2.0) if c_um4 == 0.0 else (a, b_um2, -2.0, c_um4, -4.0)
        return cls(Dispersion("cauchy", coefficients, wavelength_range_nm), absorption_per_mm, name)

    @classmethod
    def sellmeier(
        cls,
        b: Sequence[float],
        c_um2: Sequence[float],
        *,
        offset: float = 0.0,
        wavelength_range_nm: tuple[float, float],
        absorption_per_mm: float | AbsorptionSpectrum = 0.0,
        name: str | None = None,
    ) -> Medium:
        """A medium of Sellmeier's law, n² = 1 + offset + Σ Bᵢλ²/(λ² − Cᵢ), λ in µm (theory/media.md, eq. 2).

        Parameters
        ----------
        b, c_um2 : sequences of float, equally long
            Bᵢ [1] and Cᵢ [µm²]: squares of the resonances' wavelengths, as glass catalogues print them.
        offset : float, default 0
        wavelength_range_nm : tuple of two floats [nm]
            Where the law holds; outside it is an error.
        absorption_per_mm, name
            As of :class:`Medium`.

        Raises
        ------
        ClerestoryError
            If n falls below 1 in the range (at a resonance, say), or the range is empty.
        """
        b, c_um2 = vector("b", b), vector("c_um2", c_um2)
        same_length("c_um2", c_um2, b)
        coefficients = (offset, *(x for pair in zip(b, c_um2, strict=True) for x in pair))
        return cls(Dispersion("sellmeier", coefficients, wavelength_range_nm), absorption_per_mm, name)

    @classmethod
    def tabulated(
        cls,
        wavelength_nm: ArrayLike,
        n: ArrayLike,
        *,
        extinction: ArrayLike | None = None,
        absorption_per_mm: ArrayLike | None = None,
        name: str | None = None,
    ) -> Medium:
        """A medium measured at some wavelengths, straight lines in between.

        Parameters
        ----------
        wavelength_nm : array_like, shape (w,), increasing [nm]
        n : array_like, shape (w,), at least 1
        extinction : array_like, shape (w,), optional
            Extinction coefficient k, the imaginary part of the index.
        absorption_per_mm : array_like, shape (w,), or float, optional [1/mm]
            Instead of ``extinction``; neither: lossless.
        name : str, optional

        Raises
        ------
        ClerestoryError
            If the wavelengths do not increase, lengths differ, both absorptions are given, or a value is impossible.
        """
        wavelengths, index = vector("wavelength_nm", wavelength_nm), vector("n", n)
        same_length("n", index, wavelengths)
        pairs = tuple(x for pair in zip(wavelengths, index, strict=True) for x in pair)
        absorption: float | AbsorptionSpectrum = 0.0
        if extinction is not None and absorption_per_mm is not None:
            raise ClerestoryError("extinction and absorption_per_mm must not both be given, got both; leave one out")
        if extinction is not None:
            absorption = AbsorptionSpectrum("extinction", wavelengths, vector("extinction", extinction))
        elif absorption_per_mm is not None and np.ndim(absorption_per_mm) == 0:
            absorption = number("absorption_per_mm", absorption_per_mm)
        elif absorption_per_mm is not None:
            absorption = AbsorptionSpectrum("per_mm", wavelengths, vector("absorption_per_mm", absorption_per_mm))
        return cls(Dispersion("tabulated", pairs), absorption, name)

    @classmethod
    def named(cls, name: str) -> Medium:
        """A medium of the packaged tables, e.g. ``"pmma"``; :func:`medium_names` lists them.

        Raises
        ------
        ClerestoryError
            If there is none of this name; the message lists those there are.
        """
        if not isinstance(name, str):
            raise ClerestoryError(f"name must be text, got {name!r}; one of {', '.join(medium_names())}")
        laws = _native.Medium.named(name)
        law, coefficients, range_nm = laws.dispersion
        quantity, values = laws.absorption
        n = coefficients[0] if law == "constant" else Dispersion(law, tuple(coefficients), range_nm)
        absorption = (
            values[0]
            if quantity == "constant"
            else AbsorptionSpectrum(quantity, tuple(values[::2]), tuple(values[1::2]))
        )
        return cls(n, absorption, name)

    @property
    def is_spectral(self) -> bool:
        """Whether index or absorption depends on the wavelength."""
        return self._laws.is_spectral

    @property
    def wavelength_range_nm(self) -> tuple[float, float] | None:
        """Shortest and longest wavelength for which both are known [nm]; None: all."""
        return self._laws.wavelength_range_nm

    @property
    def source(self) -> str | None:
        """Who measured it, of a packaged medium."""
        return _native.medium_source(self.name) if self.name is not None and self._is_packaged() else None

    def index(self, wavelength_nm: ArrayLike | None = None) -> FloatOrArray:
        """Refractive index.

        Parameters
        ----------
        wavelength_nm : array_like, optional [nm]
            Inside :attr:`wavelength_range_nm`. May be left out if the medium is not spectral.

        Returns
        -------
        float or ndarray of the wavelengths' shape

        Raises
        ------
        ClerestoryError
            If a wavelength is outside the range, not positive, or missing.
        """
        return elementwise(lambda w: [self._laws.index(w)], self._wavelengths(wavelength_nm))[0]

    def absorption_per_mm_at(self, wavelength_nm: ArrayLike | None = None) -> FloatOrArray:
        """Absorption coefficient of the power [1/mm]; arguments, shapes and errors as of :meth:`index`."""
        return elementwise(lambda w: [self._laws.absorption_per_mm(w)], self._wavelengths(wavelength_nm))[0]

    def with_absorption(self, absorption_per_mm: float | AbsorptionSpectrum) -> Medium:
        """The same index with another absorption [1/mm]."""
        return replace(self, absorption_per_mm=absorption_per_mm)

    def to_dict(self) -> dict[str, Any]:
        """Plain values for TOML or JSON; a packaged medium is its name alone."""
        if self._is_packaged():
            return {"name": self.name}
        n = self.n.to_dict() if isinstance(self.n, Dispersion) else self.n
        alpha = self.absorption_per_mm
        absorption = alpha.to_dict() if isinstance(alpha, AbsorptionSpectrum) else alpha
        name = {} if self.name is None else {"name": self.name}
        return name | {"n": n, "absorption_per_mm": absorption}

    @classmethod
    def from_dict(cls, values: Mapping[str, Any] | str) -> Medium:
        """The medium of :meth:`to_dict`'s values; a name alone, or only ``{"name": …}``, is a packaged medium.

        Raises
        ------
        ClerestoryError
            If a key is unknown or a value impossible.
        """
        if isinstance(values, str):
            return cls.named(values)
        if not isinstance(values, Mapping):
            raise ClerestoryError(f'medium must be a name or a table, got {values!r}; write medium = "pmma", say')
        known_keys("medium", values, {"name", "n", "absorption_per_mm"})
        if set(values) == {"name"}:
            return cls.named(values["name"])
        arguments = dict(values)
        if isinstance(values.get("n"), Mapping):
            arguments["n"] = Dispersion.from_dict(values["n"])
        if isinstance(values.get("absorption_per_mm"), Mapping):
            arguments["absorption_per_mm"] = AbsorptionSpectrum.from_dict(values["absorption_per_mm"])
        return cls(**arguments)

    def _wavelengths(self, wavelength_nm: ArrayLike | None) -> ArrayLike:
        if wavelength_nm is not None:
            return numbers("wavelength_nm", wavelength_nm)
        if self.is_spectral:
            low, high = self.wavelength_range_nm or (0.0, math.inf)
            raise ClerestoryError(
                f"wavelength_nm must be given for a spectral medium, got None; choose one from {low:g} to {high:g} nm"
            )
        # any will do
        return 550.0

    def _is_packaged(self) -> bool:
        return self.name in _native.medium_names() and self == Medium.named(str(self.name))


def medium_names() -> list[str]:
    """The names that :meth:`Medium.named` knows."""
    return _native.medium_names()


AIR = Medium(n=1.0, name="air")
PMMA = Medium.named("pmma")
PMMA_SULTANOVA = Medium.named("pmma_sultanova")
POLYCARBONATE = Medium.named("polycarbonate")
SODA_LIME_CLEAR = Medium.named("soda_lime_clear")
SODA_LIME_LOW_IRON = Medium.named("soda_lime_low_iron")
SODA_LIME_GREY = Medium.named("soda_lime_grey")
SODA_LIME_BRONZE = Medium.named("soda_lime_bronze")
BK7 = Medium.named("bk7")
