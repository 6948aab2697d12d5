"""Displacement and stress of the rings at a stored state, on their whole solids."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property
from os.path import exists  # Path.exists raises for names that no file can have
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

import fem
from fem.parts.resolution import neighbour
from fem.parts.surroundings import Surroundings
from flexbearing.build import expansion, ring_parts, roller_bearing
from flexbearing.case import BadCase, understood
from flexbearing.case.head import Head
from flexbearing.case.roller import Case
from flexbearing.files import require_folder, require_output, write as store
from flexbearing.results import BadResult, Result
from flexbearing.rings.condensed import IN_SPACE, mesh_size, patches
from flexbearing.runs.dangers import yielding
from quasidynamic.contact.line import Slices
from quasidynamic.note import Note

if TYPE_CHECKING:
    from fem.parts.rings import Part
    from fem.parts.step_solid import StepSolid
    from fem.solid.extremes import BodyExtremes, Sampled
    from fem.solid.factored_solid import FactoredSolid
    from fem.solid.fields import LoadedSolid

Race = Literal["inner", "outer"]
Arrays = Mapping[str, Any]  # name to array

NAMES = {"inner": "inner ring and shaft", "outer": "outer ring"}
MEGA = 1e6  # Pa per MPa
# Order and sizes of elements over the roller length: of whole solids, which are drawn and give the stiffness
# of supports, and of the meshes for stresses, on a section or of half a pitch.
WITHOUT_BARS = (3, 1.2, 0.4)
FOR_STRESSES = {fem.OuterRing: (6, 0.6, 0.2), fem.RingOnShaft: (6, 0.6, 0.2), fem.SquirrelCage: (5, 0.6, 0.4)}


class NoFields(RuntimeError):
    """A part that displacements and stresses cannot be computed of; the message says why."""


@dataclass(frozen=True, kw_only=True)
class PartFields:
    """A part under the rollers of one state; what is asked for is solved then, and kept."""

    race: Race
    state: str  # "rigid", "flexible", "iteration 3"
    part: Part | StepSolid
    patches: fem.Patches
    forces: NDArray  # (Z, M) [N] positive outward
    sizes: Sizes
    surroundings: Surroundings  # heat and rotation, which the largest stresses hold
    left_out: str  # what they do not hold; empty: nothing

    @cached_property
    def solid(self) -> FactoredSolid:
        """The whole solid, factored; raises `NoFields`."""
        from fem.condense import require_drawing
        from fem.solid.factored_solid import factored

        with self._solving():
            require_drawing(self.part, self.patches.length)
            return factored(self.part, self.patches, self.sizes.solid, self.sizes.threads)

    @cached_property
    def loaded(self) -> LoadedSolid:
        """The whole solid under its rollers; raises `NoFields`."""
        with self._solving():
            return self.solid.under(self.forces)

    @cached_property
    def extremes(self) -> dict[str, BodyExtremes]:
        """Largest stresses of every body with their errors; raises `NoFields`."""
        from fem.solid.clearing import clearing
        from fem.solid.extremes import extremes

        with self._solving():
            radius, sampled = self._sampled()
            clear = clearing(self.part, self.patches, self.forces, radius)
            return {body: extremes(sampled, body, clear) for body in self.part.materials}

    def _sampled(self) -> tuple[float, Sampled]:
        """Radius of the raceway [m], and the part by two orders of displacements on a mesh for stresses."""
        loads = self.patches, self.forces
        if isinstance(self.part, fem.SquirrelCage):
            from fem.cage.loaded_cage import feet_size, loaded_cage

            feet = feet_size(self.part) * self.sizes.coarseness
            cage = loaded_cage(self.part, *loads, self.sizes.stresses, feet)
            return cage.radius, cage
        if isinstance(self.part, fem.OuterRing | fem.RingOnShaft):
            from fem.section.loaded_section import loaded_section

            section = loaded_section(self.part, *loads, self.sizes.stresses, self.surroundings)
            return section.radius, section
        from fem.solid.whole_solid import WholeSolid

        return self.loaded.radius, WholeSolid(self._neighbour.under(self.forces), self.loaded)

    @property
    def _neighbour(self) -> FactoredSolid:
        """The whole solid by another order of displacements, which tells the error."""
        return self.solid.of_order(neighbour(self.sizes.solid.order))

    def support(self) -> dict[str, float]:
        """Stiffness of the support against tilt and along the axis, with estimated errors.

        Raises
        ------
        NoFields
            if it could not be solved
        """
        from fem.solid.support_stiffness import support_stiffness

        with self._solving():
            held, other = (support_stiffness(solid) for solid in (self.solid, self._neighbour))
        return {
            "tilting_Nm_per_rad": held.tilting,
            "tilting_error_Nm_per_rad": abs(held.tilting - other.tilting),
            "axial_N_per_m": held.axial,
            "axial_error_N_per_m": abs(held.axial - other.axial),
        }

    def record(self) -> dict[str, Any]:
        """Largest values with their errors and units, as JSON can hold them.

        Raises
        ------
        NoFields
            if something could not be solved
        """
        began = perf_counter()
        bodies = {name: _body_record(most) for name, most in self.extremes.items()}
        steady = self.surroundings.speed or any(self.surroundings.thermal_strains.values())
        return {
            "bodies": bodies,
            "loads": "rollers, heat and rotation" if steady else "rollers",
            "left_out": self.left_out,
            "support": self.support(),
            "seconds": perf_counter() - began,
        }

    @contextmanager
    def _solving(self) -> Iterator[None]:
        from fem.assembly.factorisation import NotSolved

        try:
            # threads of the linear algebra would fight with those of the finite elements
            with threadpool_limits(limits=1, user_api="blas"):
                yield
        except (fem.ImpossiblePart, NotSolved) as problem:
            raise NoFields(f"{NAMES[self.race]}: {problem}") from problem


@dataclass(frozen=True)
class Sizes:
    """Elements of the whole solid, those of the mesh for stresses, and threads."""

    solid: fem.MeshSize
    stresses: fem.MeshSize
    coarseness: float  # of the latter over that of the usual mesh, where the case asks for another [-]
    threads: int


def dangers(case: Case, race: Race, record: dict[str, Any]) -> Iterator[Note]:
    """Danger of bodies whose largest von Mises stress is above the yield stress of their material.

    Parameters
    ----------
    case : Case
        which may give yield stresses
    race : "inner" or "outer"
        which part
    record : dict
        of `PartFields.record`

    Yields
    ------
    Note
        "yield-stress"
    """
    for body, most in record["bodies"].items():
        material = expansion.material(case, body if body in ("shaft", "housing") else f"{race}_ring")
        name = f"{race} ring" if body == "ring" else body
        limit = getattr(material, "yield_stress", None)  # not every material may have one
        yield from yielding(name, MEGA * most["von_mises_MPa"], limit)


def _body_record(most: BodyExtremes) -> dict[str, float]:
    """Extremes of a body with their units; the place is that of the largest von Mises stress."""
    record = {}
    for name in ("von_mises", "tension", "compression"):
        largest = getattr(most, name)
        record[f"{name}_MPa"] = largest.value / MEGA
        record[f"{name}_error_MPa"] = largest.error / MEGA
    return record | {
        "displacement_um": 1e6 * most.displacement,
        "x_mm": 1e3 * most.von_mises.x,
        "radius_mm": 1e3 * most.von_mises.radius,
        "azimuth_deg": float(np.degrees(most.von_mises.azimuth)),
    }


def case_of(result: Result) -> Case:
    """The case that a result file holds; its drawing is looked for beside the case, then beside the result.

    Parameters
    ----------
    result : Result
        of a roller bearing

    Returns
    -------
    Case

    Raises
    ------
    BadCase
        if it cannot be read, or is about balls, whose rings are rigid, or known at the balls only
    """
    case = _understood(result, Path(result.attributes.get("case_file", result.path)))
    drawing = case.drawing if isinstance(case, Case) else None
    if drawing and not exists(drawing):  # noqa: PTH110, carried elsewhere: the drawing may have come along
        case = _understood(result, result.path)
    if not isinstance(case, Case):
        raise BadCase(f"{result.path}: the rings of a {case.kind} bearing have no fields; only rollers have")
    return case


def _understood(result: Result, file: Path) -> Head:
    """The case in a result, as if it stood in a file."""
    attributes = result.attributes
    try:
        return understood(
            attributes["case_text"], file, attributes["case_overrides"], {result.kind: result.family}
        )
    except BadCase as problem:
        first, *_ = str(problem).splitlines()
        raise BadCase(f"{result.path}: the case in it cannot be read: {first}") from problem


def state_of(result: Result, name: str) -> Arrays:
    """Arrays of a stored state.

    Parameters
    ----------
    result : Result
        of a roller bearing
    name : str
        "rigid", "flexible", or "iteration N" with N from 1

    Returns
    -------
    mapping
        name to array

    Raises
    ------
    BadResult
        if there is no such state
    """
    count = len(result.iterations)
    iteration = re.fullmatch(r"iteration ([1-9][0-9]{0,8})", name)
    if iteration and int(iteration[1]) <= count:
        return result.iterations[int(iteration[1]) - 1]
    blocks = {"rigid": result.rigid, "flexible": result.flexible}
    if blocks.get(name):
        return blocks[name]
    there = [block for block, values in blocks.items() if values]
    there += [f"iteration 1 to iteration {count}"] if count else []
    raise BadResult(f"{result.path}: there is no state {name!r}; there are: {', '.join(there) or 'none'}.")


def parts(case: Case) -> dict[Race, Any]:
    """Parts of a case that are flexible.

    Parameters
    ----------
    case : Case
        of a run, or from its result

    Returns
    -------
    dict
        part by its raceway

    Raises
    ------
    NoFields
        if a part cannot be built
    """
    try:
        both: dict[Race, Any] = {"inner": ring_parts.inner_part(case), "outer": ring_parts.outer_part(case)}
    except fem.ImpossiblePart as problem:
        raise NoFields(str(problem)) from problem
    return {race: part for race, part in both.items() if part is not None}


def fields(case: Case, race: Race, state: str, values: Arrays) -> PartFields:
    """A part under the roller loads of a state; it is solved for what is asked of it.

    Parameters
    ----------
    case : Case
        what the state is of
    race : "inner" or "outer"
        which part; it is flexible
    state : str
        name of the state
    values : mapping
        its arrays, as in a result file

    Returns
    -------
    PartFields

    Raises
    ------
    NoFields
        if the part has no solid, or is not bonded to what holds it

    Valid
    -----
    Normal loads only: tractions of the rollers, about a hundredth of them, do not load the part.
    """
    _require_solid(case, race)
    part, loads = parts(case)[race], patches(case, roller_bearing.bearing(case).bearing.azimuths)
    plain = isinstance(part, fem.OuterRing | fem.RingOnShaft)
    usual = FOR_STRESSES[type(part)] if plain or isinstance(part, fem.SquirrelCage) else IN_SPACE
    sizes = Sizes(
        solid=mesh_size(case, WITHOUT_BARS if plain else IN_SPACE),
        stresses=(stresses := _of_two_orders(mesh_size(case, usual))),
        coarseness=stresses.size / (usual[1] * loads.length),
        threads=case.accuracy.threads,
    )
    turning = case.operation.outer_speed != 0 and not plain and race == "outer"
    return PartFields(
        race=race, state=state, part=part, patches=loads,
        forces=forces(values[f"{race}_slice_load"], race, loads.length, loads.axial_modes),
        sizes=sizes, surroundings=surroundings(case, race) if plain else Surroundings(),
        left_out="rotation" if turning else "",
    )  # fmt: skip


def _of_two_orders(sizes: fem.MeshSize) -> fem.MeshSize:
    """Sizes whose order has a useful one below it."""
    return replace(sizes, order=max(sizes.order, 3))


def surroundings(case: Case, race: Race) -> Surroundings:
    """Heat and rotation of a ring with its shaft or housing.

    Its bodies are meshed as warm as the ring: what counts is by how much the other body grows more.

    Parameters
    ----------
    case : Case
        with temperatures, or without
    race : "inner" or "outer"
        which ring

    Returns
    -------
    Surroundings
    """
    ring, mate, name = (
        ("inner_ring", "shaft", "shaft") if race == "inner" else ("outer_ring", "housing", "housing")
    )
    hot = {body: expansion.hot_over_cold(case, body) for body in (ring, mate)}
    speed = case.operation.inner_speed if race == "inner" else case.operation.outer_speed
    return Surroundings(
        thermal_strains={"ring": 0.0, name: hot[mate] / hot[ring] - 1},
        densities={
            "ring": expansion.material(case, ring).density,
            name: expansion.material(case, mate).density,
        },
        speed=speed,
    )


def _require_solid(case: Case, race: Race) -> None:
    """Refuse parts that are computed on their section only."""
    if race == "inner" and case.inner.fit != "bonded":
        raise NoFields(
            f'{NAMES[race]}: inner.fit = "{case.inner.fit}" has no solid, only a bonded ring has one'
        )
    if race == "inner" or case.outer.kind != "ring":
        return
    if case.lifts_off:
        raise NoFields(f"{NAMES[race]}: bearing.fits.housing has no solid, only a bonded ring has one")
    if case.outer.support not in ("side", "seat", "housing"):
        raise NoFields(
            f'{NAMES[race]}: outer.support = "{case.outer.support}" has no solid; '
            '"side", "seat" and "housing" have one'
        )


def forces(slice_loads: NDArray, race: Race, length: float, shapes: int) -> NDArray:
    """Generalised forces on a raceway.

    Parameters
    ----------
    slice_loads : array (Z, K)
        load per length on the slices of the rollers [N/m], >= 0
    race : "inner" or "outer"
        rollers push the inner raceway inwards
    length : float
        of the roller [m]
    shapes : int
        M, Legendre shapes along it

    Returns
    -------
    array (Z, M)
        [N] positive outward
    """
    outward = slice_loads @ Slices(slice_loads.shape[1], length, shapes).weights
    return outward if race == "outer" else -outward


def of_result(result: Result, state: str = "flexible", race: Race | None = None) -> list[PartFields]:
    """Fields of the flexible parts of a result.

    Parameters
    ----------
    result : Result
        what a run left behind
    state : str
        as for `state_of`
    race : "inner" or "outer", optional
        only this part

    Returns
    -------
    list of PartFields

    Raises
    ------
    BadCase
        if no such part is flexible
    BadResult
        if there is no such state
    NoFields
        if a part has no solid, or it could not be solved
    """
    case, values = case_of(result), state_of(result, state)
    return [fields(case, name, state, values) for name in _races(result, case, race)]


def destinations(
    result: Result, directory: Path, state: str = "flexible", race: Race | None = None
) -> dict[Race, Path]:
    """Settle where the fields go, named after result, part and state, before anything is computed.

    Parameters
    ----------
    result : Result
        what a run left behind
    directory : Path
        where to; made when it is not there
    state, race
        as for `of_result`

    Returns
    -------
    dict
        file by raceway

    Raises
    ------
    BadCase, BadResult, NoFields
        as `of_result`
    BadOutput
        if a file cannot be written
    """
    case = case_of(result)
    state_of(result, state)
    races, folder = _races(result, case, race), require_folder(directory)
    paths: dict[Race, Path] = {
        name: folder / f"{result.path.stem}_{name}_{state.replace(' ', '_')}.vtu" for name in races
    }
    for path in paths.values():
        require_output(path, (result.path, *case.input_files))
    return paths


def _races(result: Result, case: Case, race: Race | None) -> list[Race]:
    """Raceways of the flexible parts, or the one that is asked for."""
    for block in filter(None, (result.rigid, result.flexible)):
        rollers = block["roller_azimuth"].size
        if rollers != case.bearing.rollers:
            raise BadResult(
                f"{result.path}: {rollers} rollers in its arrays, {case.bearing.rollers} in its case; "
                "run the case again."
            )
    flexible = parts(case)
    races: list[Race] = [race] if race else list(flexible)
    if not races or any(name not in flexible for name in races):
        what = NAMES[race] if race else "every part"
        raise BadCase(f"{result.path}: {what} is rigid in this case: it has no displacements and stresses")
    return races


def write(part: PartFields, path: Path) -> None:
    """Write fields for ParaView.

    Parameters
    ----------
    part : PartFields
        with its fields
    path : Path
        from `destinations`

    Raises
    ------
    NoFields
        if the solid could not be solved
    NotStored
        if there is no room for the file
    """
    from fem.solid.vtu import vtu

    store(path.resolve(), vtu(part.loaded.displacement, part.part.materials))
