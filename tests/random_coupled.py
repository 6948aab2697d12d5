"""Random bearings between flexible rings, as case files with settings; each is found again by its number."""

from dataclasses import dataclass

import numpy as np

PAPER, TEXTBOOK = "configs/mao2016.toml", "configs/nu209.toml"
SOLID_SUPPORTS = ("side", "seat", "housing")  # of a ring that can be a full solid
BEAM_SUPPORTS = ("side", "foundation")  # of a ring that can be a curved beam
SUPPORTS = ("side", "seat", "foundation", "housing", "loose housing", "lines", "planet")
SECTION = ("accuracy.element_order=3", "accuracy.raceway_mesh_size=0.6 mm")  # fine enough for 0.6 mm
FIT = ("accuracy.element_order=4", "accuracy.raceway_mesh_size=0.6 mm", "accuracy.axial_shapes=5")
STEEL = ("youngs_modulus=207 GPa", "poisson_ratio=0.3", "density=7850 kg/m^3", "expansion=11.5e-6 1/K")


@dataclass(frozen=True)
class Base:
    """What the settings of a bearing need of its case file."""

    case: str
    rollers: int
    outer_raceway: float  # [mm]
    roller_diameter: float  # [mm]
    roller_length: float  # [mm]
    width: float  # [mm] of a ring
    bore: float  # [mm] of the inner ring
    fastest: float  # [rpm]


BASES = (
    Base(PAPER, 30, 75.0, 5.0, 5.0, 10.0, 59.6, 38_000.0),
    Base(TEXTBOOK, 14, 75.032, 10.0, 9.601, 19.0, 45.0, 12_000.0),
)


@dataclass(frozen=True)
class Design:
    """A case file and the settings that make it this design."""

    case: str
    settings: tuple[str, ...]

    def command(self) -> str:
        """The command that runs it."""
        return " ".join(
            [f"flexbearing run {self.case}", *(f"--set '{setting}'" for setting in self.settings)]
        )


def design(seed: int, number: int, solid: bool = False) -> Design:
    """A random design.

    Rings of 0.6 to 15 mm on every support, cages of 1 to 40 bars, shafts, fits; clearance -40 to 200 um,
    20 N to 50 kN, misalignment and moments, loads on a roller, between two, and anywhere.

    Parameters
    ----------
    seed, number : int
        which one
    solid : bool
        whether its outer ring is a full solid
    """
    rng = np.random.default_rng([seed, number])
    base = BASES[rng.integers(2)]
    load = _log_uniform(rng, 20.0, 50e3)
    settings = [
        "accuracy.threads=1",
        f"accuracy.slices={rng.choice([10, 20])}",
        f"bearing.clearance={rng.uniform(-40, 200):.2f} um",
        f"bearing.first_roller_azimuth={_first_roller(rng, 360 / base.rollers):.4f} deg",
        f"operation.radial_load={load:.4g} N",
        f"operation.inner_speed={_log_uniform(rng, 100.0, base.fastest):.4g} rpm",
        *_tilt(rng, load, base),
    ]
    if rng.random() < 0.2:
        settings.append(f"operation.load_direction={rng.uniform(0, 360):.2f} deg")
    rigid_outer = not solid and rng.random() < 0.08
    settings += ["outer.kind=rigid"] if rigid_outer else _outer(rng, base, load, solid)
    settings += _inner(rng, base, solid) if rigid_outer or rng.random() < 0.35 else ["inner.kind=rigid"]
    return Design(base.case, tuple(settings))


def _log_uniform(rng: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def _first_roller(rng: np.random.Generator, pitch: float) -> float:
    """Azimuth [deg]: a roller under the load, the load between two, or anywhere."""
    return float(rng.choice([0.0, pitch / 2, rng.uniform(0, pitch)]))


def _tilt(rng: np.random.Generator, load: float, base: Base) -> list[str]:
    """A ring that is held straight, held oblique, or free under a moment."""
    kind = rng.choice(["straight", "oblique", "free"], p=[0.5, 0.35, 0.15])
    if kind == "straight":
        return ["operation.tilt=fixed", "operation.moment=0 N m"]
    if kind == "oblique":
        slope = rng.choice([-1, 1]) * _log_uniform(rng, 0.2, 6.0)
        return [
            "operation.tilt=fixed",
            "operation.moment=0 N m",
            f"operation.misalignment={slope:.3f} arcmin",
        ]
    return [
        "operation.tilt=free",
        f"operation.moment={rng.uniform(-0.15, 0.15) * load * base.roller_length:.4g} N mm",
    ]


def _outer(rng: np.random.Generator, base: Base, load: float, solid: bool) -> list[str]:
    """An outer ring or cage, and how it is discretised."""
    thickness = _log_uniform(rng, 0.6, 15.0)
    ring = [f"outer.thickness={thickness:.3f} mm", f"outer.width={base.width:g} mm"]
    if rng.random() < 0.3:
        bars = int(rng.integers(1, 41))
        structure = (
            "solid"
            if solid
            else "beam"
            if rng.random() < 0.1 and bars > 8
            else ("smeared" if rng.random() < 0.4 and bars > 8 else "harmonics")
        )
        mesh = {"beam": (), "smeared": SECTION}.get(structure, ("accuracy.element_order=2",))
        return [
            "outer.kind=squirrel_cage", *ring, *_bars(rng, base, bars, thickness),
            f"accuracy.structure={structure}", *mesh,
        ]  # fmt: skip
    support = str(rng.choice(SOLID_SUPPORTS if solid else SUPPORTS))
    beam = support in BEAM_SUPPORTS and thickness < 5.0 and rng.random() < 0.4
    structure = "solid" if solid else "beam" if beam else "harmonics"
    mesh = () if beam else ("accuracy.element_order=2",) if solid else SECTION
    return [
        "outer.kind=ring", *ring, f"accuracy.structure={structure}", *mesh,
        *_support(rng, base, support, load),
    ]  # fmt: skip


def _bars(rng: np.random.Generator, base: Base, bars: int, thickness: float) -> list[str]:
    thin = min(rng.uniform(0.4, 0.8) * thickness, thickness - 0.25)
    around = np.pi * (base.outer_raceway + thickness - thin)
    return [
        f"outer.bars={bars}",
        f"outer.bar_thickness={thin:.3f} mm",
        f"outer.bar_width={min(rng.uniform(0.2, 0.7) * around / bars, 10.0):.3f} mm",
        f"outer.bar_length={rng.uniform(4, 25):.2f} mm",
        "outer.flange_length=5 mm",
    ]


def _support(rng: np.random.Generator, base: Base, support: str, load: float) -> list[str]:
    """What holds a plain ring."""
    name = "housing" if support == "loose housing" else support
    settings = [f"outer.support={name}"]
    if support == "foundation":
        radial = _log_uniform(rng, 1.0, 1e3)
        settings += [
            f"outer.foundation_radial={radial:.3g} N/mm^3",
            f"outer.foundation_tangential={radial * rng.choice([0, 0.3, 1.0]):.3g} N/mm^3",
            f"outer.foundation_axial={radial * rng.choice([0.1, 1.0]):.3g} N/mm^3",
        ]
    if name == "housing":
        settings += [
            f"outer.housing_thickness={_log_uniform(rng, 2, 20):.2f} mm",
            f"outer.housing_width={base.width:g} mm",
            f"outer.housing_support={rng.choice(['seat', 'side'])}",
            *_steel("housing"),
        ]
    if support == "loose housing":
        settings += [f"outer.housing_clearance={rng.uniform(0, 60):.1f} um", *FIT]
        if base.case == PAPER:  # which has temperatures
            settings += ['operation.temperatures.housing="218 degC"']
    if support == "lines":
        count, first = int(rng.integers(3, 13)), rng.uniform(0, 360)
        azimuths = ", ".join(f'"{(first + 360 * k / count) % 360:.2f} deg"' for k in range(count))
        settings += [f"outer.line_azimuths=[{azimuths}]"]
    if support in ("lines", "foundation") and rng.random() < 0.2:
        settings += ["outer.bilateral=true"]
    if support == "planet":
        settings += _teeth(rng, load)
    return settings


def _teeth(rng: np.random.Generator, load: float) -> list[str]:
    """Two meshes at opposite places, whose tangential forces carry the load and whose radial ones cancel."""
    radial = -rng.uniform(0, 0.4) * load
    return [
        'outer.tooth_azimuths=["90 deg", "270 deg"]',
        f'outer.tooth_radial=["{radial:.4g} N", "{radial:.4g} N"]',
        f'outer.tooth_tangential=["{load / 2:.4g} N", "{-load / 2:.4g} N"]',
    ]


def _inner(rng: np.random.Generator, base: Base, solid: bool) -> list[str]:
    """An inner ring on a hollow shaft, bonded or in a fit."""
    raceway = base.outer_raceway - 2 * base.roller_diameter
    bore = rng.uniform(base.bore, raceway - 2.0)
    settings = [
        "inner.kind=ring_on_shaft",
        f"inner.bore={bore:.2f} mm",
        f"inner.thickness={(raceway - bore) / 2 + 2:.3f} mm",
        f"inner.width={base.width + 4:g} mm",
        f"inner.track_width={base.roller_length + 1:g} mm",
        f"inner.shaft_thickness={_log_uniform(rng, 0.6, 15.0):.3f} mm",
        f"inner.shaft_length={rng.uniform(base.width + 5, 80):.1f} mm",
        *_steel("shaft"),
    ]
    if rng.random() < 0.12 and not solid:  # the mesh of a fit is far too fine for a solid
        fit = str(rng.choice(["frictionless", "friction"]))
        settings += [
            f"inner.fit={fit}",
            f"bearing.fits.shaft_interference={rng.uniform(10, 60):.1f} um",
            *FIT,
        ]
    return settings


def _steel(part: str) -> list[str]:
    return [f"materials.{part}.{setting}" for setting in STEEL]
