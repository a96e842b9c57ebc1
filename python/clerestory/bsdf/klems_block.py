"""One matrix of a BSDF over patches of Klems bases."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from clerestory.bsdf.klems import Floats, KlemsBasis, klems_basis
from clerestory.errors import ClerestoryError


@dataclass(frozen=True, eq=False)
class KlemsBlock:
    """How a window element sends light from each incident patch into each outgoing one.

    Parameters
    ----------
    values : array of shape (outgoing, incident) [1/sr]
        Radiance that leaves over irradiance that arrives; not multiplied by a cosine or a solid angle.
    incident_basis, outgoing_basis : str or KlemsBasis, default "klems_full"
        A patch is named by the (x, y) in which light travels, on both sides: what goes straight on and what is mirrored
        lie on the diagonal.
    standard_error : array of the shape of values, optional [1/sr]
        Of values that were drawn at random.

    Raises
    ------
    ClerestoryError
        If the shape is not that of the bases, or a value is not finite.
    """

    values: Floats
    incident_basis: KlemsBasis | str = "klems_full"
    outgoing_basis: KlemsBasis | str = "klems_full"
    standard_error: Floats | None = None

    def __post_init__(self) -> None:
        for name in ("incident_basis", "outgoing_basis"):
            try:
                basis = klems_basis(getattr(self, name))
            except ClerestoryError as cause:
                raise ClerestoryError(f"{name}: {cause}") from cause
            object.__setattr__(self, name, basis)
        object.__setattr__(self, "values", self._checked("values", self.values))
        if self.standard_error is not None:
            object.__setattr__(self, "standard_error", self._checked("standard_error", self.standard_error))

    def _checked(self, name: str, given: Any) -> Floats:
        try:
            values = np.array(given, dtype=np.float64)
        except (TypeError, ValueError):
            raise ClerestoryError(f"{name} must be a matrix of numbers, got {type(given).__name__}") from None
        shape = (len(self.outgoing), len(self.incident))
        if values.shape != shape:
            raise ClerestoryError(
                f"{name} must have shape (outgoing, incident) = {shape} for {self.outgoing.name} and "
                f"{self.incident.name}, got {values.shape}"
            )
        if not np.isfinite(values).all():
            row, column = np.argwhere(~np.isfinite(values))[0]
            raise ClerestoryError(
                f"{name} must be finite, got {values[row, column]} at outgoing patch {row} and incident patch {column}"
            )
        values.flags.writeable = False
        return values

    @property
    def incident(self) -> KlemsBasis:
        """Patches that light arrives from."""
        return klems_basis(self.incident_basis)

    @property
    def outgoing(self) -> KlemsBasis:
        """Patches that light leaves into."""
        return klems_basis(self.outgoing_basis)

    def hemispherical(self) -> Floats:
        """Share of the power of each incident patch that leaves, shape (incident,) (theory/bsdf.md, eq. 3)."""
        return np.asarray(self.outgoing.projected_solid_angle @ self.values)

    def hemispherical_standard_error(self) -> Floats | None:
        """Of :meth:`hemispherical`, the entries taken as independent; None if the values are exact."""
        if self.standard_error is None:
            return None
        return np.sqrt((self.outgoing.projected_solid_angle**2) @ (self.standard_error**2))

    def at(self, incident: npt.ArrayLike, outgoing: npt.ArrayLike) -> Floats:
        """Value for light that travels in along one direction and out along another [1/sr].

        Parameters
        ----------
        incident, outgoing : arrays of shape (..., 2)
            (x, y) of the directions of travel.
        """
        i, o = np.asarray(incident, dtype=np.float64), np.asarray(outgoing, dtype=np.float64)
        return np.asarray(
            self.values[self.outgoing.find(o[..., 0], o[..., 1]), self.incident.find(i[..., 0], i[..., 1])]
        )

    def hemispherical_at(self, incident: npt.ArrayLike) -> Floats:
        """Share of the power that leaves for light along each of the directions (x, y), shape (...,)."""
        i = np.asarray(incident, dtype=np.float64)
        return np.asarray(self.hemispherical()[self.incident.find(i[..., 0], i[..., 1])])

    def mean(self) -> float:
        """Share that leaves of light that comes from everywhere with one radiance (theory/bsdf.md, eq. 4)."""
        return float(self.hemispherical() @ self.incident.projected_solid_angle / np.pi)

    def reversed(self) -> KlemsBlock:
        """The block for light that goes the other way along the same paths (theory/bsdf.md, eq. 5).

        Raises
        ------
        ClerestoryError
            If a basis has no patch opposite to each patch.
        """
        back, forth = self.outgoing.opposite, self.incident.opposite
        if back is None or forth is None:
            name = self.outgoing.name if back is None else self.incident.name
            raise ClerestoryError(f"basis {name!r} must have an even number of bins in each ring to turn light round")
        values = self.values[np.ix_(back, forth)].T
        error = None if self.standard_error is None else self.standard_error[np.ix_(back, forth)].T
        return KlemsBlock(values, self.outgoing, self.incident, error)
