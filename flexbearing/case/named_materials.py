"""Materials by name, with what makers and handbooks print of them."""

from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class NamedMaterial:
    """A material of the table, its values in the words of a case file."""

    youngs_modulus: str
    poisson_ratio: float
    density: str
    expansion: str
    yield_stress: str | None = None  # none was found printed, or the material breaks before it yields
    source: str


MATERIALS = {
    "100Cr6": NamedMaterial(
        youngs_modulus="210 GPa",
        poisson_ratio=0.30,
        density="7810 kg/m^3",
        expansion="11.9e-6 1/K",
        yield_stress="2034 MPa",
        source="hardened, as AISI 52100; modulus and Poisson's ratio: SNFA, comparison of bearing steel with "
        "silicon nitride; density, expansion from 23 to 280 degC: data sheet of SAE 52100; yield stress: "
        "295 000 psi, data sheet of chrome steel balls, HRC 60 to 67",
    ),
    "M50": NamedMaterial(
        youngs_modulus="214 GPa",
        poisson_ratio=0.29,
        density="7870 kg/m^3",
        expansion="11.84e-6 1/K",
        source="AISI M50 VIM-VAR, data sheet of BTI Metals, expansion from 21 to 204 degC; Poisson's ratio: "
        "MakeItFrom, annealed SAE-AISI M50; no yield stress was found printed",
    ),
    "Si3N4": NamedMaterial(
        youngs_modulus="315 GPa",
        poisson_ratio=0.26,
        density="3190 kg/m^3",
        expansion="3.2e-6 1/K",
        source="silicon nitride for balls: SNFA, comparison with bearing steel, expansion from 20 to 1000 "
        "degC; brittle, without a yield stress",
    ),
    "structural steel": NamedMaterial(
        youngs_modulus="210 GPa",
        poisson_ratio=0.30,
        density="7850 kg/m^3",
        expansion="12e-6 1/K",
        yield_stress="235 MPa",
        source="EN 1993-1-1, 3.2.6 and table 3.1: S235, the least of its grades, up to 40 mm thick; density: "
        "EN 1991-1-1, table A.4",
    ),
    "grey cast iron": NamedMaterial(
        youngs_modulus="110 GPa",
        poisson_ratio=0.26,
        density="7200 kg/m^3",
        expansion="11e-6 1/K",
        yield_stress="165 MPa",
        source="EN-GJL-250 after DIN EN 1561, as SN-Castiron prints it: modulus 103 to 118 GPa, 0.1 % proof "
        "stress 165 to 228 MPa; expansion: MakeItFrom, EN-JL 1040",
    ),
}


def values(name: str, keys: Iterable[str]) -> dict[str, object]:
    """Values of a material for some keys of its table, in the words of a case file."""
    material = MATERIALS[name]
    return {key: value for key in keys if (value := getattr(material, key, None)) is not None}


def origin(name: str) -> str:
    """What the table has of a material, in a line."""
    material = MATERIALS[name]
    limit = f", yield stress {material.yield_stress}" if material.yield_stress else ""
    return (
        f"Young's modulus {material.youngs_modulus}, Poisson's ratio {material.poisson_ratio}, density "
        f"{material.density}, expansion {material.expansion}{limit} ({material.source})"
    )
