from os import PathLike
from typing import Any, Iterable, Iterator, Literal, Mapping, Protocol, Sequence, TypedDict
from typing_extensions import Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str
__all__ = ["Atoms", "Error", "FileMissing", "Movie", "Structure", "UsageError", "View", "__version__", "density_map", "from_arrays",
           "from_biopython", "from_gemmi", "open", "options"]

class Error(RuntimeError): ...
class FileMissing(Error, FileNotFoundError):
    def __init__(self, message: str, path: str | None = ...) -> None: ...
class UsageError(ValueError): ...

Mask = NDArray[np.bool_]
Table = Mapping[str, Sequence[Any]] | Sequence[Mapping[str, Any]] | Any  # or a DataFrame

class Layers(TypedDict):
    rgba: NDArray[np.float32]
    z: NDArray[np.float32]
    normal: NDArray[np.float32]
    id: NDArray[np.uint32]
    occlusion: NDArray[np.float32]

# Output of `nacre help keywords`.
class Options(TypedDict, total=False):
    look: str | PathLike[str]
    thumbnail: str | float
    pocket: str | Mask
    interface: str | tuple[str | Mask, str | Mask]
    camera: str
    occlusion_models: str
    assembly: str | float
    style: str
    bond_orders: str | bool
    aromatic_bonds: str
    color: str
    color_from: str | PathLike[str] | Table | Sequence[str | Table]
    palette: str
    helices: str
    bases: str
    putty: str | bool
    carbohydrates: str | bool
    line_width: str | float
    stick_radius: str | float
    bond_radius: str | float
    tube_radius: str | float
    ball_scale: str | float
    cartoon_scale: str | float
    gaps: str | bool
    surface_form: str
    disulfides: str | bool
    surface: str
    probe: str | float
    surface_resolution: str | float
    cavities: str | bool
    surface_opacity: str | float
    cartoon_opacity: str | float
    atom_opacity: str | float
    ellipsoids: str
    probability: str | float
    interactions: str | bool | Mask | tuple[str | Mask, str | Mask]
    interaction_kinds: str
    interaction_rules: str
    interaction_color: str | Sequence[str]
    interaction_width: str | float
    show: str | tuple[str | Mask, str] | Sequence[str | tuple[str | Mask, str]]
    hide: str | Mask | Sequence[str | Mask]
    color_by: str | tuple[str | Mask, str] | Sequence[str | tuple[str | Mask, str]]
    water: str | bool
    hydrogens: str | bool
    altlocs: str | float
    map: str | PathLike[str] | Sequence[str | PathLike[str]]
    map_level: str | float | Sequence[str | float]
    map_style: str | Sequence[str]
    map_color: str | Sequence[str]
    map_color_from: str | PathLike[str] | Sequence[str | PathLike[str]]
    map_slice: str | Sequence[str]
    map_transfer: str | Sequence[str]
    map_opacity: str | float | Sequence[str | float]
    map_width: str | float
    map_around: str | Mask | tuple[str | Mask, float]
    surface_color_from: str | PathLike[str]
    electrostatics: str | bool
    primitives: str | PathLike[str] | Sequence[str | PathLike[str]]
    cell: str | bool
    projection: str
    stereo: str
    eye_distance: str | float
    screen_distance: str | float
    fov: str | float
    zoom: str | float
    scale: str | float
    center: str | Sequence[float] | Mask
    orientation: str | Sequence[float]
    pan: str | Sequence[float]
    rotate: str | Sequence[float]
    orient: str | Mask
    look_at: str | Mask
    zoom_to: str | Mask
    uncover: str | bool | Mask
    background: str
    transparent: bool
    lighting: str | bool
    occlusion: str | float | bool
    bounce: str | bool
    occlusion_memory: str | float
    contours: str | float | bool
    contour_depth: str | float
    contour_weights: str | float
    contour_color: str
    halos: str | float | bool
    halo_depth: str | float
    halo_strength: str | float
    halo_color: str
    fog: str | Sequence[float] | bool
    fog_strength: str | float
    shadow: str | float | bool
    depth_of_field: str | float | bool
    focus_depth: str | float
    material: str
    ambient: str | float
    direct: str | float
    highlight: str | float
    gloss: str | float
    occlusion_strength: str | float
    clip: str | float | Sequence[float] | bool | Mask
    cap: str
    cap_color: str
    clip_spare: str | Mask
    slab: str | float
    label: str | tuple[str | Mask, str] | Sequence[str | tuple[str | Mask, str]]
    label_color: str | tuple[str | Mask, str] | Sequence[str | tuple[str | Mask, str]]
    label_offset: str | tuple[str | Mask, str] | Sequence[str | tuple[str | Mask, str]]
    measure: str | tuple[str | Mask | int, ...] | Sequence[str | tuple[str | Mask | int, ...]]
    title: str | float
    scale_bar: str | bool
    legend: str | bool
    legend_title: str | float
    axes: str | bool
    interaction_labels: str | bool
    show_labels: str
    text_size: str | float
    text_color: str
    occlusion_detail: str | float
    size: str | Sequence[float]
    supersample: str | float
    mesh_error: str | float
    width: str
    height: str
    dpi: str | float
    depth: str | float
    debug: str
    device: str | float
    visibility: str
    msaa: str | bool
    encoded_format: str
    prepass: str | bool
    transient: str | bool
    merge: str | bool
    validate: bool
class OwnColors(Options, total=False):
    color: str | ArrayLike  # type: ignore[misc]
    color_limits: Sequence[float]

class Still(OwnColors, total=False):
    frame: int

class Movie:
    data: bytes
    type: str
    frames: int
    def __init__(self, data: bytes, type: str, frames: int) -> None: ...
    def _repr_mimebundle_(self, include: Any = ..., exclude: Any = ...) -> dict[str, str]: ...

class Atoms(dict[str, NDArray[Any]]):
    def to_frame(self) -> Any: ...

class Structure:
    def __init__(self, core: Any, maps: Sequence[str | PathLike[str]] = ...) -> None: ...
    def __len__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def title(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def atoms(self) -> Atoms: ...
    @property
    def bonds(self) -> NDArray[np.uint32]: ...
    @property
    def frames(self) -> int: ...
    def frame(self, number: int) -> Structure: ...
    def info(self, *, interactions: str | Mask | tuple[str | Mask, str | Mask] | None = ..., interaction_kinds: str | None = ...,
             interaction_rules: str | None = ..., assembly: str | None = ...) -> dict[str, Any]: ...
    def select(self, selection: str) -> NDArray[np.bool_]: ...
    def render(self, **options: Unpack[Still]) -> NDArray[np.uint8] | NDArray[np.uint16]: ...
    def pictures(self, views: Iterable[Mapping[str, Any]], **options: Unpack[OwnColors]) -> Iterator[NDArray[np.uint8] | NDArray[np.uint16]]: ...
    def layers(self, **options: Unpack[Still]) -> Layers: ...
    def save(self, path: str | PathLike[str], **options: Unpack[Still]) -> None: ...
    def export(self, path: str | PathLike[str], **options: Unpack[Still]) -> None: ...
    def movie(self, path: str | PathLike[str] | None = ..., *, spin: str | Sequence[float] | None = ...,
              turns: float | None = ..., rock: float | None = ..., axis: str | Sequence[float] | None = ...,
              easing: str | None = ..., map_sweep: str | None = ..., models: bool = ..., morph: bool = ..., loop: bool = ...,
              seconds: float | None = ..., fps: float | None = ...,
              **options: Unpack[OwnColors]) -> Movie: ...
    def view(self, *, size: Sequence[int] = ..., **options: Any) -> View: ...
    def _repr_png_(self) -> bytes: ...

class View:
    structure: Structure
    size: tuple[int, int]
    picked: int | None
    frame: int
    def __init__(self, structure: Structure, size: Sequence[int], options: dict[str, Any]) -> None: ...
    @property
    def description(self) -> dict[str, Any]: ...
    @property
    def url(self) -> str: ...
    def picture(self, **options: Unpack[OwnColors]) -> NDArray[np.uint8] | NDArray[np.uint16]: ...
    def save(self, path: str | PathLike[str], **options: Unpack[OwnColors]) -> None: ...
    def _repr_mimebundle_(self, include: Any = ..., exclude: Any = ...) -> dict[str, str]: ...

class _Readable(Protocol):
    def read(self) -> str | bytes: ...

def open(source: Any | str | PathLike[str] | Sequence[str | PathLike[str]] | bytes | bytearray | memoryview | _Readable, *, name: str = ...,
         maps: Sequence[str | PathLike[str]] = ..., format: str = ...,
         model: int | Literal["all"] = ..., **options: Any) -> Structure: ...
def from_arrays(positions: ArrayLike, elements: ArrayLike, bonds: ArrayLike | None = ..., *, names: ArrayLike = ...,
                residue_names: ArrayLike = ..., residue_numbers: ArrayLike = ..., chains: ArrayLike = ...,
                b_factors: ArrayLike = ..., occupancies: ArrayLike = ..., name: str = ...) -> Structure: ...
def density_map(name: str, values: ArrayLike, cell: Sequence[float], *, origin: Sequence[float] = ...,
                crystal: bool = ...) -> str: ...
def from_gemmi(structure: Any, **options: Any) -> Structure: ...
def from_biopython(entity: Any, **options: Any) -> Structure: ...
def options() -> dict[str, str]: ...
