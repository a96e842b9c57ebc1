"""The compiled half of the package: what ``crates/python`` exposes."""

from collections.abc import Callable, Sequence
from typing import Any, Literal

from numpy import float32, float64, int64, uint16
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
    def glazing(self) -> Glazing: ...
    def section_beams(
        self, incident: NDArray[float64], y_range_mm: tuple[float, float], least_power: float
    ) -> tuple[NDArray[float64], list[float], list[int], list[int]]: ...

class Glazing:
    @staticmethod
    def open() -> Glazing: ...
    @staticmethod
    def constant(transmittance: float) -> Glazing: ...
    @staticmethod
    def glass(transmittance: float) -> Glazing: ...
    @staticmethod
    def tregenza_sharples() -> Glazing: ...
    @staticmethod
    def slab(n: float, thickness_mm: float, absorption_per_mm: float) -> Glazing: ...
    @staticmethod
    def bsdf_matrix(
        incident_basis: str | KlemsBasis,
        outgoing_basis: str | KlemsBasis,
        transmission_front: NDArray[float64] | None,
        transmission_back: NDArray[float64] | None,
        reflection_front: NDArray[float64] | None,
        reflection_back: NDArray[float64] | None,
    ) -> Glazing: ...
    @staticmethod
    def bsdf_tree(
        rank: int,
        transmission_front: NDArray[float64] | None,
        transmission_back: NDArray[float64] | None,
        reflection_front: NDArray[float64] | None,
        reflection_back: NDArray[float64] | None,
    ) -> Glazing: ...
    def klems(
        self,
        basis: str | KlemsBasis,
        *,
        tolerance: float,
        levels: int,
        draws: int,
        seed: int,
    ) -> tuple[
        list[NDArray[float64]],
        list[NDArray[float64]] | None,
        tuple[NDArray[float64], list[tuple[str, float]]],
    ]: ...
    def tree(
        self,
        rank: int,
        log2_resolution: int,
        *,
        merged: float,
        tolerance: float,
        levels: int,
        draws: int,
        seed: int,
    ) -> tuple[list[NDArray[float64]], tuple[NDArray[float64], list[tuple[str, float]]] | None]: ...
    @property
    def has_lobes(self) -> bool: ...
    @property
    def spreads(self) -> bool: ...
    def bsdf(self, incident: NDArray[float64], outgoing: NDArray[float64]) -> NDArray[float64]: ...
    def spread(self, incident: NDArray[float64]) -> NDArray[float64]: ...
    def scatter(self, incident: NDArray[float64], seed: int) -> NDArray[float64]: ...
    def lobes(
        self, incident: NDArray[float64]
    ) -> tuple[NDArray[float64], NDArray[float64], NDArray[uint16], float, float]: ...

class KlemsBasis:
    def __new__(cls, name: str) -> KlemsBasis: ...
    @staticmethod
    def of_rings(name: str, theta_low_deg: Sequence[float], counts: Sequence[int]) -> KlemsBasis: ...
    @property
    def name(self) -> str: ...
    def __len__(self) -> int: ...
    @property
    def theta_bounds_deg(self) -> NDArray[float64]: ...
    @property
    def counts(self) -> list[int]: ...
    @property
    def solid_angle(self) -> NDArray[float64]: ...
    @property
    def projected_solid_angle(self) -> NDArray[float64]: ...
    @property
    def centres(self) -> NDArray[float64]: ...
    def find(self, xy: NDArray[float64]) -> NDArray[int64]: ...

class Stack:
    SHARES: list[str]
    def __new__(
        cls, spectrum: Sequence[Sequence[Glazing]], *, weights: Sequence[float], is_resolved: bool
    ) -> Stack: ...
    def lobes(
        self, incident: NDArray[float64]
    ) -> tuple[NDArray[float64], NDArray[float64], NDArray[uint16], NDArray[float64], tuple[float, float, float]]: ...
    def shares(self, incident: NDArray[float64]) -> NDArray[float64]: ...
    def glazing(self) -> Glazing: ...

class SkyBasis:
    def __new__(cls, name: str) -> SkyBasis: ...
    @property
    def name(self) -> str: ...
    def __len__(self) -> int: ...
    @property
    def centres(self) -> NDArray[float64]: ...
    @property
    def solid_angles(self) -> NDArray[float64]: ...
    @property
    def bounds(self) -> NDArray[float64]: ...
    def order(self, order: str) -> NDArray[int64]: ...
    def find(self, directions: NDArray[float64]) -> NDArray[int64]: ...
    def sample(self, patch: NDArray[int64], u: NDArray[float64]) -> NDArray[float64]: ...
    def all_weather(
        self, parameters: NDArray[float64], suns: NDArray[float64], horizontal: NDArray[float64], order: int
    ) -> NDArray[float32]: ...
    def overcast(self, ground_reflectance: float) -> NDArray[float64]: ...

class Material:
    def __new__(cls, diffuse: float, specular: float = 0.0) -> Material: ...
    @property
    def diffuse(self) -> float: ...
    @property
    def specular(self) -> float: ...

class SceneBuilder:
    def __new__(cls) -> SceneBuilder: ...
    def polygon(
        self, name: str, outline: NDArray[float64], material: Material, holes: list[NDArray[float64]] = ...
    ) -> None: ...
    def mesh(self, name: str, vertices: NDArray[float64], triangles: NDArray[int64], material: Material) -> None: ...
    def window(
        self,
        name: str,
        outline: NDArray[float64],
        glazing: Glazing,
        up: Sequence[float] | None = None,
        wall: str | None = None,
    ) -> None: ...
    def interface(
        self,
        name: str,
        vertices: NDArray[float64],
        triangles: NDArray[int64],
        front: tuple[float, float],
        back: tuple[float, float],
    ) -> None: ...
    def build(self) -> Scene: ...

class Scene:
    @property
    def surfaces(self) -> list[str]: ...
    @property
    def kinds(self) -> list[Literal["opaque", "window", "interface"]]: ...
    @property
    def areas(self) -> NDArray[float64]: ...
    def triangles(self) -> tuple[NDArray[float64], NDArray[int64]]: ...
    def closest(
        self, origins: NDArray[float64], directions: NDArray[float64]
    ) -> tuple[NDArray[float64], NDArray[int64]]: ...
    def unfollowed_mirrors(self) -> list[tuple[str, int, int]]: ...

def daylight_coefficients(
    scene: Scene,
    points: NDArray[float64],
    normals: NDArray[float64],
    basis: SkyBasis,
    *,
    seed: int = 0,
    rounds: int = 16,
    nodes: int = 512,
    window_samples: int = 512,
    max_bounces: int | None = None,
    target_relative_error: float | None = None,
    max_rounds: int = 4096,
    weights: NDArray[float64] | None = None,
    threads: int | None = None,
    progress: Callable[[int, int, float, float], bool | None] | None = None,
) -> dict[str, Any]: ...
def centre_coefficients(
    scene: Scene, points: NDArray[float64], normals: NDArray[float64], basis: SkyBasis
) -> dict[str, NDArray[float64]]: ...
def sun_coefficients(
    scene: Scene,
    points: NDArray[float64],
    normals: NDArray[float64],
    sun_directions: NDArray[float64],
    *,
    seed: int = 0,
    rounds: int = 8,
    nodes: int = 1024,
    disc_samples: int = 1,
    max_bounces: int | None = None,
    any_sun: bool = False,
    threads: int | None = None,
    progress: Callable[[int, int, float, float], bool | None] | None = None,
) -> dict[str, Any]: ...

class AnySun:
    def __new__(
        cls,
        scene: Scene,
        points: NDArray[float64],
        normals: NDArray[float64],
        *,
        seeds: Sequence[int],
        rounds: int,
        nodes: int,
    ) -> AnySun: ...
    def light(self, sun_direction: NDArray[float64], first: int, end: int) -> NDArray[float64]: ...
    @property
    def nbytes(self) -> int: ...

def sun_way(
    scene: Scene,
    sun_direction: NDArray[float64],
    *,
    points: int,
    bounces: int,
    least_power: float,
    beyond_m: float,
    most_shades: int,
) -> dict[str, dict[str, NDArray[Any]]]: ...
