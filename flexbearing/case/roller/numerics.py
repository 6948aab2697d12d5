"""The sections [coupling] and [accuracy]."""

from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case import accuracy
from flexbearing.case.coupling import MethodsOfCoupling
from flexbearing.case.quantity import Fraction, Length, Section, impossible, key

AXIAL_MODES = (2, 4, 6, 8)  # of a target, two at a time: of a pair one may do nothing; the last measures
MORE_SHAPES = 4  # axial shapes beyond those that a case fixes, by which a target measures their error


class Coupling(MethodsOfCoupling):
    """The same for rollers, whose rings may be solved in full."""

    structure: Literal["condensed", "full"] = key(
        "condensed: rings are condensed once to their raceways; full: the whole solid of every "
        "flexible ring is factored once and solved anew in every iteration, for all methods but newton",
        "condensed",
    )

    @model_validator(mode="after")
    def _newton_knows_how_rings_yield(self) -> Self:
        if self.structure == "full" and self.method == "newton":
            raise impossible(
                "method",
                '"iqn-ils", "anderson", "aitken" or "relaxed" for coupling.structure = "full": newton needs '
                "the compliance of the rings, which a solve under given loads does not give",
            )
        return self


class Accuracy(Section):
    """How finely everything is resolved: as given, or as a target requires; what is given stays."""

    target: Fraction | None = accuracy.target("roller")
    slices: int = key("slices of a roller", 20, ge=2, le=1000)
    axial_shapes: int = key(
        "Legendre shapes along a roller that carry loads to the rings and deviations back", 3, ge=2, le=6
    )
    structure: Literal["beam", "smeared", "harmonics", "solid"] = key(
        "harmonics: rings of revolution on their axial section, a squirrel cage on half a pitch; "
        "solid: everything as a full solid; smeared: the bars of a squirrel cage as a sleeve, all on axial "
        "sections; beam: rings as curved beams, without a mesh",
        "harmonics",
    )
    element_order: int | None = key(
        "polynomial order of the finite elements; by default 5 on an axial section, 3 in a solid",
        None,
        example=3,
        ge=1,
        le=8,
    )
    mesh_size: Length | None = key(
        "largest size of the elements; by default 1.2 roller lengths on an axial section, 0.6 in a solid",
        None,
        example="3 mm",
        gt=0,
    )
    raceway_mesh_size: Length | None = key(
        "largest size of the elements on a raceway; by default a quarter of the roller length on an axial "
        "section, 0.4 in a solid",
        None,
        example="2 mm",
        gt=0,
    )
    harmonics: int | None = key(
        "highest azimuthal harmonic; by default as many as the axial shapes require",
        None,
        example=60,
        ge=8,
        le=1000,
    )
    patch_width: Length | None = key(
        "standard deviation of the load patch along the arc of a full solid, without its half-space "
        "indentation; by default a tenth of the roller length",
        None,
        example="0.5 mm",
        gt=0,
    )
    threads: int | None = key(
        "threads of NGSolve for whole solids, at most the cores that the run may use; left out: all of them",
        None,
        example=2,
        ge=1,
        le=64,
    )

    @model_validator(mode="after")
    def _slices_carry_the_shapes_that_measure_a_target(self) -> Self:
        fixed = self.model_fields_set
        shapes = self.axial_shapes + MORE_SHAPES if "axial_shapes" in fixed else AXIAL_MODES[-1]
        if self.target is not None and "slices" in fixed and self.slices < shapes:
            raise impossible(
                "slices",
                f"at least {shapes} with accuracy.target, which compares up to {shapes} axial shapes and "
                "needs as many slices; or leave accuracy.slices out: the target chooses them",
            )
        return self
