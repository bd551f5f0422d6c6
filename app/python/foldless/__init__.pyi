# SPDX-License-Identifier: GPL-3.0-or-later
from os import PathLike
from typing import Any, Optional, Sequence, TypedDict, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str

class Error(ValueError):
    """A mesh, a handle or a file that cannot be used, in one sentence."""

class Iteration:
    """The record of one vertex update; lengths are those of the input, counters are totals."""
    @property
    def phase(self) -> str: ...
    @property
    def distortion_energy(self) -> float: ...
    @property
    def penalty_energy(self) -> float: ...
    @property
    def barrier_energy(self) -> float: ...
    @property
    def energy(self) -> float: ...
    @property
    def gradient_norm_squared(self) -> float: ...
    @property
    def handle_error_squared(self) -> float: ...
    @property
    def step_length(self) -> float: ...
    @property
    def min_area_ratio(self) -> float: ...
    @property
    def max_conformal_distortion(self) -> float: ...
    @property
    def mean_conformal_distortion(self) -> float: ...
    @property
    def factorizations(self) -> int: ...
    @property
    def updates(self) -> int: ...
    @property
    def flips(self) -> int: ...
    @property
    def splits(self) -> int: ...
    @property
    def seconds(self) -> float: ...

class Parents:
    """How the vertices of a result lie in the input mesh."""
    @property
    def triangles(self) -> NDArray[np.int32]:
        """(#U,) the input triangle of every vertex; -1: none."""
    @property
    def coordinates(self) -> NDArray[np.float64]:
        """(#U, 3) barycentric coordinates of every vertex in it."""
    @property
    def outputs(self) -> NDArray[np.int32]:
        """(#V,) the vertex of every input vertex."""

class Result:
    """A mesh and its image under a map without folds; arrays are read-only views."""
    @property
    def V(self) -> NDArray[np.float64]:
        """(#U, 2) at rest, the vertices of the input first."""
    @property
    def F(self) -> NDArray[np.int32]:
        """(#F, 3) triangles of V and U."""
    @property
    def U(self) -> NDArray[np.float64]:
        """(#U, 2) deformed."""
    @property
    def parents(self) -> Parents: ...
    @property
    def reached(self) -> bool:
        """Every handle is at its target."""
    @property
    def verdict(self) -> str:
        """One sentence on how it ended, where there is more to say."""
    @property
    def outcome(self) -> Optional[str]:
        """gradient, step, iteration-limit, infeasible, not-converged, cancelled, time-limit, or
        None while it can go on."""
    @property
    def log(self) -> list[Iteration]:
        """A record for every vertex update since the targets were set."""
    @overload
    def map(self, points: ArrayLike) -> NDArray[np.float64]:
        """Takes (#P, 2) points of the input mesh to where they are deformed."""
    @overload
    def map(self, points: ArrayLike, coordinates: ArrayLike) -> NDArray[np.float64]:
        """Takes points in (#P,) input triangles at (#P, 3) barycentric coordinates."""

class Session:
    """A run that goes on whenever its targets move: s.targets[3] = x, y.

    cancel() and what is read may be called from any thread."""
    def __init__(self, V: ArrayLike, F: ArrayLike, handles: ArrayLike, targets: ArrayLike, *,
                 energy: str = "arap", time_limit: Optional[float] = None, threads: int = 1,
                 fixed_triangulation: bool = False, beta: Optional[float] = None) -> None: ...
    @property
    def targets(self) -> NDArray[np.float64]:
        """(#handles, 2) where the handles are to go; write into it or replace it."""
    @targets.setter
    def targets(self, targets: ArrayLike) -> None: ...
    def step(self) -> bool:
        """One vertex update; False when there was none."""
    def run(self) -> bool:
        """Steps to the end; False when the time limit or cancel() stopped it."""
    def cancel(self) -> None:
        """Ends the step() or run() under way in another thread, or the next."""
    @property
    def result(self) -> Result:
        """The newest valid mesh."""
    @property
    def U(self) -> NDArray[np.float64]:
        """(#U, 2) deformed, of the newest valid mesh."""
    @property
    def reached(self) -> bool: ...
    @property
    def ended(self) -> bool: ...

class Folds(TypedDict):
    inverted: int
    degenerate: int
    branch_vertices: int
    overlapping_boundary_vertices: list[int]

class CheckedMap(TypedDict):
    injective: bool
    rest: Folds
    deformed: Folds
    min_area_ratio: float
    max_conformal_distortion: float
    mean_conformal_distortion: float

def solve(V: ArrayLike, F: ArrayLike, handles: ArrayLike, targets: ArrayLike, *,
          energy: str = "arap", time_limit: Optional[float] = None, threads: int = 1,
          fixed_triangulation: bool = False, beta: Optional[float] = None) -> Result:
    """Deforms a mesh so that vertices come to targets without a fold. threads: how many share the
    work on large meshes; the result is the same bits with any number."""

def check(V: ArrayLike, F: ArrayLike, U: ArrayLike) -> CheckedMap:
    """Whether the map that takes (#V, 2) V to U on (#F, 3) triangles is locally injective, proved
    with exact predicates, and how much it distorts."""

def energies() -> list[str]:
    """The names of the distortion energies."""

def mesh_image(path: Union[str, PathLike[str]], *, detail: str = "medium"
               ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """V, F of what is opaque in a picture, in its pixels, (0, 0) the lower left corner, y up.
    detail: coarse, medium or fine, about 500, 2,000 or 8,000 vertices."""

def render(result: Result, path: Union[str, PathLike[str]], *, view: str = "both",
           width: int = 1200, height: int = 900,
           texture: Optional[Union[str, PathLike[str]]] = None) -> None:
    """Draws a result into a .png, .svg or .pdf. view: deformed, rest or both. texture: the picture
    that the mesh was made of by mesh_image()."""
