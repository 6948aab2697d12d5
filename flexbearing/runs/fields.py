"""Displacement and stress of the rings at a stored state, on their whole solids."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from os.path import exists  # Path.exists raises for names that no file can have
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

import fem
from flexbearing.build import expansion, ring_parts, roller_bearing
from flexbearing.case import BadCase, understood
from flexbearing.case.head import Head
from flexbearing.case.roller import Case
from flexbearing.files import NotStored, require_folder, require_output, write as store
from flexbearing.results import BadResult, Result
from flexbearing.rings.condensed import IN_SPACE, PATCH, mesh_size
from quasidynamic.contact.line import Slices

if TYPE_CHECKING:
    from fem.cage.bar_forces import BarForces
    from fem.solid.fields import LoadedSolid
    from fem.solid.support_stiffness import SupportStiffness

Race = Literal["inner", "outer"]
Arrays = Mapping[str, Any]  # name to array

NAMES = {"inner": "inner ring and shaft", "outer": "outer ring"}
MEGA = 1e6  # Pa per MPa
WITHOUT_BARS = (3, 1.2, 0.4)  # order and sizes over the roller length: 2 % of the shaft's largest stress
VTU_END = b"</VTKFile>"


class NoFields(RuntimeError):
    """A part that displacements and stresses cannot be computed of; the message says why."""


@dataclass(frozen=True, kw_only=True)
class PartFields:
    """A part under the rollers of one state."""

    race: Race
    state: str  # "rigid", "flexible", "iteration 3"
    fields: LoadedSolid
    support: SupportStiffness
    bars: BarForces | None  # of a squirrel cage

    def record(self) -> dict[str, Any]:
        """Largest values with their units, as JSON can hold them."""
        bodies = {
            name: {
                "von_mises_MPa": most.von_mises / MEGA,
                "tension_MPa": most.tension / MEGA,
                "compression_MPa": most.compression / MEGA,
                "displacement_um": 1e6 * most.displacement,
                "x_mm": 1e3 * most.x,
                "radius_mm": 1e3 * most.radius,
                "azimuth_deg": float(np.degrees(most.azimuth)),
            }
            for name, most in self.fields.largest().items()
        }
        nominal = None if self.bars is None else float(self.bars.stress.max() / MEGA)
        return {
            "bodies": bodies,
            "nominal_bar_stress_MPa": nominal,
            "support": {
                "radial_N_per_m": self.support.radial,
                "tilting_Nm_per_rad": self.support.tilting,
                "axial_N_per_m": self.support.axial,
            },
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
    """Solve a part under the roller loads of a state.

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
        if the part has no solid, is not bonded to what holds it, or could not be solved

    Valid
    -----
    Normal loads only: tractions of the rollers, about a hundredth of them, do not load the solid.
    """
    # NGSolve takes a second to load: only who asks for fields waits for it.
    from fem.assembly.factorisation import NotSolved
    from fem.cage.bar_forces import bar_forces
    from fem.condense import require_drawing
    from fem.solid.factored_solid import factored
    from fem.solid.support_stiffness import support_stiffness

    length = expansion.roller_length(case)
    patches = fem.Patches(
        azimuths=tuple(roller_bearing.bearing(case).bearing.azimuths),
        length=length,
        axial_modes=case.accuracy.axial_shapes,
        width=case.accuracy.patch_width or PATCH * length,
    )
    _require_solid(case, race)
    part = parts(case)[race]
    sizes = WITHOUT_BARS if isinstance(part, fem.OuterRing | fem.RingOnShaft) else IN_SPACE
    try:
        # threads of the linear algebra would fight with those of the finite elements
        with threadpool_limits(limits=1, user_api="blas"):
            require_drawing(part, length)
            solid = factored(part, patches, mesh_size(case, sizes), case.accuracy.threads)
            loaded = solid.under(forces(values[f"{race}_slice_load"], race, length, patches.axial_modes))
            bars = bar_forces(loaded) if isinstance(part, fem.SquirrelCage) else None
            return PartFields(
                race=race, state=state, fields=loaded, support=support_stiffness(solid), bars=bars
            )
    except (fem.ImpossiblePart, NotSolved) as problem:
        raise NoFields(f"{NAMES[race]}: {problem}") from problem


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
    NotStored
        if there is no room for the file, here or in the folder for temporary files
    """
    with TemporaryDirectory() as folder:
        data = part.fields.write(Path(folder) / path.name).read_bytes()
    if not data.rstrip().endswith(VTU_END):  # NGSolve does not notice a full disk
        raise NotStored(
            f"{path}: not written: no space left in {Path(folder).parent}. Free space there, or name another "
            "folder for temporary files in TMPDIR."
        )
    store(path.resolve(), data)
