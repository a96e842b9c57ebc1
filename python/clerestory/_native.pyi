"""The compiled half of the package: what ``crates/python`` exposes."""

from collections.abc import Sequence
from typing import Literal

from numpy import float64, uint16
from numpy.typing import NDArray

__version__: str

class Medium:
    def __new__(
        cls,
        law: str,
        coefficients: Sequence[float],
        wavelength_range_nm: tuple[float, float] | None,
        quantity: str,
        values: Sequence[float],
    ) -> Medium: ...
    @staticmethod
    def named(name: str) -> Medium: ...
    @property
    def dispersion(
        self,
    ) -> tuple[
        Literal["constant", "sellmeier", "cauchy", "polynomial", "tabulated"], list[float], tuple[float, float] | None
    ]: ...
    @property
    def absorption(self) -> tuple[Literal["constant", "per_mm", "extinction"], list[float]]: ...
    @property
    def wavelength_range_nm(self) -> tuple[float, float] | None: ...
    @property
    def is_spectral(self) -> bool: ...
    def index(self, wavelength_nm: NDArray[float64]) -> NDArray[float64]: ...
    def absorption_per_mm(self, wavelength_nm: NDArray[float64]) -> NDArray[float64]: ...

def medium_names() -> list[str]: ...
def medium_source(name: str) -> str: ...
def tregenza_sharples(cos_i: NDArray[float64]) -> NDArray[float64]: ...
def edmonds_greenup_compagnon(cos_i: NDArray[float64], n: NDArray[float64]) -> NDArray[float64]: ...
def slab(
    cos_i: NDArray[float64], n: NDArray[float64], optical_depth: NDArray[float64], polarisation: str
) -> list[NDArray[float64]]: ...
def slab_single_pass(
    cos_i: NDArray[float64], n: NDArray[float64], optical_depth: NDArray[float64]
) -> NDArray[float64]: ...
def edmonds_deflected_fraction(
    cos_i: NDArray[float64], n: NDArray[float64], width_over_spacing: NDArray[float64]
) -> NDArray[float64]: ...
def edmonds_panel_tilt(altitude: NDArray[float64]) -> NDArray[float64]: ...
def uncoated_glass(transmittance: NDArray[float64], reflectance: NDArray[float64]) -> list[NDArray[float64]]: ...

class Profile:
    @staticmethod
    def laser_cut(
        *,
        spacing_mm: list[float],
        thickness_mm: float,
        cut_width_mm: float,
        cut_tilt_deg: list[float],
        cut_depth_mm: list[float] | None,
        cut_radius_mm: float | None,
        cut_slope_deg: float,
        cut_diffuse: float,
    ) -> Profile: ...
    @staticmethod
    def prismatic(*, pitch_mm: float, lower_deg: float, upper_deg: float, base_mm: float, ridges: str) -> Profile: ...
    @staticmethod
    def pane(*, thickness_mm: float) -> Profile: ...
    @staticmethod
    def drawn(
        *,
        ends_mm: NDArray[float64],
        bulge: list[float],
        left: list[int],
        right: list[int],
        film: list[int],
        pitch_mm: float,
    ) -> Profile: ...
    @property
    def pitch_mm(self) -> float: ...
    @property
    def depth_range_mm(self) -> tuple[float, float]: ...
    @property
    def highest_medium(self) -> int: ...
    @property
    def is_smooth(self) -> bool: ...
    @property
    def is_straight(self) -> bool: ...
    def facets(self) -> tuple[NDArray[float64], list[float], list[int], list[int], list[int]]: ...
    def flattened(self, chords: int) -> Profile: ...

class PanelOptics:
    SHARES: list[str]
    def __new__(
        cls,
        profile: Profile,
        *,
        n: NDArray[float64],
        absorption_per_mm: NDArray[float64],
        weights: NDArray[float64],
        polarisation: str,
        tolerance: float,
        most_pieces: int,
    ) -> PanelOptics: ...
    def lobes(
        self, incident: NDArray[float64]
    ) -> tuple[NDArray[float64], NDArray[float64], NDArray[uint16], list[float], int]: ...
    def shares(self, incident: NDArray[float64]) -> NDArray[float64]: ...
    def walk_shares(
        self, incident: NDArray[float64], rays: int, seed: int
    ) -> tuple[NDArray[float64], NDArray[float64]]: ...
    def section_beams(
        self, incident: NDArray[float64], y_range_mm: tuple[float, float], least_power: float
    ) -> tuple[NDArray[float64], list[float], list[int], list[int]]: ...
