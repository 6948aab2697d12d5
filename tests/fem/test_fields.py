"""Stresses and displacements of whole solids against beams, tubes and balance."""

import xml.etree.ElementTree as ET
from dataclasses import replace

import ngsolve as ngs
import numpy as np
import pytest
from pytest import approx

from fem import ClampedFace, Elastic, Housing, ImpossiblePart, MeshSize, OuterRing, Patches, SquirrelCage
from fem.assembly.elasticity import elastic_energy
from fem.mesh.notches import notches
from fem.parts.bar_section import bar_section
from fem.solid.clearing import clearing
from fem.solid.extremes import extremes
from fem.solid.factored_solid import factored
from fem.solid.lattice import lattice
from fem.solid.skin import skin
from fem.solid.stress import principal, von_mises
from fem.solid.support_stiffness import motion_forces, support_stiffness
from fem.solid.vtu import vtu
from fem.solid.whole_solid import WholeSolid
from fem.squirrel_cage.bar_forces import BarForces
from fem.squirrel_cage.loaded_cage import loaded_cage
from tests.fem.bars_of_a_solid import bars_of
from tests.fem.condensed import by_harmonics
from tests.fem.test_parts import CAGE, SHAFT

STEEL = Elastic(youngs_modulus=200e9, poisson_ratio=0.3)
LOAD = 3000.0  # [N]

# Stiff ends, slender bars: a translation bends every bar like a beam between two clamps.
BARS = SquirrelCage(
    raceway_diameter=40e-3, thickness=6e-3, width=8e-3, bars=8, bar_width=2e-3, bar_thickness=2e-3,
    bar_length=24e-3, flange_length=6e-3, elastic=STEEL,
)  # fmt: skip
AROUND = 2 * np.pi * np.arange(8) / 8
ON_BARS = Patches(azimuths=AROUND, length=6e-3, axial_modes=2, width=3e-3)


@pytest.fixture(scope="module")
def cage():
    return factored(BARS, ON_BARS, MeshSize(order=3, size=8e-3, raceway_size=8e-3), thread_number=1)


@pytest.fixture(scope="module")
def pulled(cage):
    """Loads like cos(phi) with the resultant LOAD along z."""
    forces = np.zeros((8, 2))
    forces[:, 0] = LOAD / 4 * np.cos(AROUND)
    return cage.under(forces)


@pytest.fixture(scope="module")
def tube():
    """A long tube clamped at one end, under even pressure inside."""
    part = OuterRing(
        raceway_diameter=40e-3, thickness=8e-3, width=80e-3, elastic=STEEL, support=ClampedFace()
    )
    azimuths = 2 * np.pi * np.arange(24) / 24
    patches = Patches(azimuths=azimuths, length=80e-3, axial_modes=2, width=6e-3)
    return factored(part, patches, MeshSize(order=3, size=14e-3, raceway_size=14e-3), thread_number=1)


@pytest.fixture(scope="module")
def pressed(tube):
    forces = np.zeros((24, 2))
    # a roller presses in one direction: of a wide one, this part is radial on average
    radial = np.exp(-((6e-3 / 20e-3) ** 2) / 2)
    forces[:, 0] = 50e6 * np.pi * 40e-3 * 80e-3 / 24 / radial  # 50 MPa
    return tube.under(forces)


@pytest.mark.slow
def test_bars_carry_the_load(pulled):
    """Shears of all bars add up to the load, their axial forces with their moments to its lever."""
    bars = bars_of(pulled)
    s, c = np.sin(bars.azimuths), np.cos(bars.azimuths)
    outward, along = bars.radial_shear, bars.tangential_shear
    # at the near ends of the bars, of the ring on the bar: all that rollers push on the ring goes there
    assert np.sum(outward * c - along * s) == approx(LOAD, rel=0.01)
    assert np.sum(outward * s + along * c) == approx(0, abs=0.01 * LOAD)
    assert bars.axial.sum() == approx(0, abs=0.01 * LOAD)


def test_bar_bends_like_a_beam_between_clamps(pulled):
    """Moment F L / 2 at both ends, its stress M c / I at a quarter of the length on the outer surface."""
    bars = bars_of(pulled)
    moment = LOAD / BARS.bars * BARS.bar_length / 2
    assert np.abs(bars.radial_moment[0]) == approx(moment, rel=0.03)
    assert bars.radial_moment[0, 0] * bars.radial_moment[0, 1] < 0
    # the load has a lever to the middle of the bars, which stretches and presses them
    pitch, side = (BARS.raceway_diameter + BARS.thickness) / 2, BARS.bar_width
    pull = LOAD * (BARS.bar_length + BARS.width) / 2 / (BARS.bars / 2 * pitch)
    assert abs(bars.axial[0]) == approx(pull, rel=0.02)
    section_modulus, area = side**3 / 6, side**2
    assert bars.stress[0].max() == approx(moment / section_modulus + pull / area, rel=0.02)
    x = 1e3 * (BARS.width / 2 + BARS.bar_length / 4)
    outside = 1e3 * (BARS.raceway_diameter + BARS.thickness + BARS.bar_thickness) / 2 - 1e-3
    surface = pulled.stress[0, 0](pulled.mesh(x, 0.0, outside))
    there = bars.radial_moment[0] @ [0.75, 0.25]
    assert surface == approx(there / section_modulus + bars.axial[0] / area, rel=0.03)


@pytest.mark.slow
def test_largest_bar_stress_lies_where_the_reach_of_a_foot_ends(pulled):
    """Between the stresses of a beam at its end and a thickness from it, within the error of finer meshes.

    Those are of order 5, and of order 4 with half the size at the feet: 4428 and 4427 MPa at the same place.
    Order 3 on these elements gives 4590 MPa, and 0.2 mm beside it.
    """
    mesh = MeshSize(order=4, size=6e-3, raceway_size=5e-3)
    loaded = loaded_cage(BARS, ON_BARS, pulled.forces, mesh, feet=1e-3)
    most = extremes(loaded, "bars", clearing(BARS, ON_BARS, pulled.forces, loaded.radius)).von_mises
    to_foot = min(most.x - BARS.width / 2, BARS.width / 2 + BARS.bar_length - most.x)
    assert to_foot == approx(notches(BARS).reach, rel=5e-3)
    at_the_end = bars_of(pulled).stress.max()
    assert at_the_end * (1 - 2 * BARS.bar_thickness / BARS.bar_length) < most.value < at_the_end
    assert most.value == approx(4427e6, rel=0, abs=most.error)
    assert most.error < 0.1 * most.value  # elements at the feet are twice those of a run


def test_symmetric_load_gives_a_symmetric_field(pulled):
    """Mirror images in the plane of the load, on a mesh that is not its own mirror image."""
    phi = np.radians([10.0, 45.0, 100.0])
    r, x = 21.5, 3.5
    left, right = (pulled.displacement(pulled.mesh(0 * phi + x, s * r * np.sin(phi), r * np.cos(phi)))
                   for s in (1, -1))  # fmt: skip
    assert left == approx(right * [1, -1, 1], abs=0.005 * np.abs(left).max())
    shear = bars_of(pulled).radial_moment[:, 0]
    assert shear[1:] == approx(shear[:0:-1], abs=0.01 * np.abs(shear).max())


@pytest.mark.parametrize("direction", ["radial", "tangential"])
def test_nominal_stress_of_a_bar_that_is_not_square_is_that_of_its_own_bending(direction):
    """A stress that is linear over the section is its own nominal stress, in either direction."""
    part = replace(BARS, bar_width=4e-3, bar_thickness=2e-3)
    section, slope = bar_section(part), 1e10  # [Pa/m]
    moment, none = np.full((1, 2), slope), np.zeros((1, 2))
    bent = (moment, none) if direction == "radial" else (none, moment)
    bars = BarForces(
        azimuths=np.zeros(1), axial=np.zeros(1), radial_moment=bent[0] * section.inertia[0],
        tangential_moment=bent[1] * section.inertia[1], torque=np.zeros(1), length=1.0, section=section,
    )  # fmt: skip
    edge = np.array([0.0, part.bar_width / 2])
    outside, inside = (np.sqrt(r**2 - edge**2) for r in part.bar_radii[::-1])
    largest = np.abs(np.concatenate([outside, inside]) - section.centre).max()
    expected = slope * (largest if direction == "radial" else part.bar_width / 2)
    assert bars.stress == approx(np.full((1, 2), expected), rel=1e-6, abs=0)


def test_clamp_holds_against_the_load(pulled):
    """Reactions of an uncondensed stiffness at the clamp are minus the load, on its lever to the clamp."""
    space = pulled.displacement.space
    form = ngs.BilinearForm(space, symmetric=True)
    u, v = space.TnT()
    form += elastic_energy(space.mesh, BARS.materials)(u, v)
    force = (form.Assemble().mat * pulled.displacement.vec).Evaluate().FV().NumPy().copy()
    clamped = ~np.array(list(space.FreeDofs()))
    force[~clamped] = 0

    def work(*motion):
        field = ngs.GridFunction(space)
        field.Set(ngs.CF(motion))
        return force @ field.vec.FV().NumPy()

    assert work(0, 0, 1) == approx(-LOAD, rel=1e-6)
    assert work(0, 1, 0) == approx(0, abs=1e-6 * LOAD)
    end = 1e3 * (BARS.width / 2 + BARS.bar_length + BARS.flange_length)
    # turned about y at the clamp, 1 per mm: the load works on its lever, -end
    assert work(-ngs.z, 0, ngs.x - end) == approx(LOAD * end, rel=1e-5)


@pytest.mark.slow
def test_tube_under_pressure_is_that_of_lame(pressed):
    """sigma_t = p a^2/(b^2 - a^2) (1 + b^2/r^2), sigma_r with a minus; far from the clamp."""
    a, b, p = 20.0, 28.0, 50e6
    r, phi = np.array([20.5, 24.0, 27.5]), 0.3
    places = pressed.mesh(0 * r - 20, r * np.sin(phi), r * np.cos(phi))
    sigma = pressed.stress(places).reshape(-1, 3, 3)
    t, n = np.array([0, np.cos(phi), -np.sin(phi)]), np.array([0, np.sin(phi), np.cos(phi)])
    scale = p * a**2 / (b**2 - a**2)
    hoop, radial = scale * (1 + b**2 / r**2), scale * (1 - b**2 / r**2)
    assert sigma @ t @ t == approx(hoop, rel=0.01)
    assert sigma @ n @ n == approx(radial, abs=0.01 * hoop[0])
    assert sigma[:, 0, 0] == approx(0, abs=0.01 * hoop[0])
    values = principal(pressed.stress)(places)
    assert values[:, 0] == approx(hoop, rel=0.01)
    assert np.all(np.diff(values, axis=1) <= 0)
    equivalent = np.sqrt((hoop**2 + radial**2 + (hoop - radial) ** 2) / 2)
    assert von_mises(pressed.stress)(places).ravel() == approx(equivalent, rel=0.015)


@pytest.mark.parametrize("seed", range(3))
def test_principal_stresses_are_eigenvalues(seed, cage):
    values = np.random.default_rng(seed).standard_normal((3, 3)) * 1e8
    given = np.array([values + values.T, np.diag([1e8, 1e8, 1e8]), np.diag([2e8, 2e8, -1e8])][seed % 3])
    found = principal(ngs.CF(tuple(given.ravel()), dims=(3, 3))).Compile()(cage.space.mesh(0.0, 0.0, 22.0))
    assert found == approx(np.linalg.eigvalsh(given)[::-1], abs=1e2)


def test_rigid_motions_of_the_band_are_read_exactly(cage):
    read, field = motion_forces(cage.space, cage.band), ngs.GridFunction(cage.space)
    x, y, z = ngs.x, ngs.y, ngs.z
    motions = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (z, 0, -x), (-y, x, 0)]  # tilts 1 per mm: 1000 per metre
    found = []
    for motion in motions:
        field.Set(ngs.CF(motion))
        found.append(field.vec.FV().NumPy() @ read)
    size = np.array([1, 1, 1, cage.band.radius, cage.band.radius])  # tilts as displacements of the raceway
    unit = np.array([1, 1, 1, 1e3, 1e3])
    assert found / (size * unit)[:, None] * size == approx(np.eye(5), abs=1e-5)


def test_support_is_nearly_as_stiff_as_its_bars(cage):
    """Translation bends bars between clamps, tilt and axial motion stretch them; their feet yield as well."""
    held = support_stiffness(cage)
    n, side, length = BARS.bars, BARS.bar_width, BARS.bar_length
    bending = STEEL.youngs_modulus * side**4 / length**3
    stretching = STEEL.youngs_modulus * side**2 / length
    # on its lever from the middle of the bars to that of the raceway a force also tilts the ring
    lever, pitch = (length + BARS.width) / 2, (BARS.raceway_diameter + BARS.thickness) / 2
    tilting = n * (stretching * pitch**2 / 2 + bending * length**2 / 12)
    radial = 1 / (1 / (n * bending) + lever**2 / tilting)
    assert 0.75 * n * stretching < held.axial < n * stretching
    assert 0.75 * radial < held.radial < radial
    assert 0.75 * tilting < held.tilting < tilting
    assert held.stiffness @ held.compliance == approx(np.eye(5), abs=1e-9)


@pytest.mark.slow
def test_support_is_that_of_the_harmonics(cage):
    """The whole solid against half a pitch."""
    half = by_harmonics(BARS, ON_BARS.length, 1, MeshSize(order=3, size=8e-3, raceway_size=3.6e-3), 8)
    last = half.harmonics[-1]
    first = half.response[[last + 1, last - 1], 0, last + 1, 0]
    assert 1 / support_stiffness(cage).radial == approx(2 * first.sum(), rel=0.05)


def test_skin_is_closed_around_the_solid(pulled):
    """Volume by the divergence theorem; faces between ring, bars and flange are inside."""
    corners = skin(pulled, 2).points
    volume = np.einsum("ti,ti->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    assert 1e9 * volume == approx(ngs.Integrate(ngs.CF(1), pulled.mesh), rel=0.01)


def test_vtu_holds_every_field_at_every_point(pulled, tmp_path):
    file = pulled.write(tmp_path / "cage.vtu")
    piece, fields = read_vtu(file)
    points, cells = int(piece.get("NumberOfPoints")), int(piece.get("NumberOfCells"))
    assert points == 10 * pulled.mesh.ne
    assert fields["offsets"].size == cells == 8 * pulled.mesh.ne
    assert fields["connectivity"].max() < points
    sizes = {
        "Points": 3, "displacement_mm": 3, "von_mises_MPa": 1, "principal_MPa": 3, "stress_MPa": 6, "body": 1
    }  # fmt: skip
    for name, size in sizes.items():
        assert fields[name].size == size * points, name
        assert np.isfinite(fields[name]).all(), name
    shift = np.linalg.norm(fields["displacement_mm"].reshape(-1, 3), axis=1).max()
    moved = pulled.displacement(pulled.mesh.MapToAllElements(lattice(ngs.TET, 6)[0], ngs.VOL))
    assert shift == approx(1e3 * np.linalg.norm(moved, axis=1).max(), rel=0.02)
    assert set(np.rint(fields["body"])) == {0, 1, 2}


def test_vtu_cells_fill_the_solid_and_are_of_one_type(pulled):
    """Small tetrahedra all the same way round, their volume that of the curved ones."""
    _, fields = vtu_arrays(vtu(pulled.displacement, BARS.materials))
    assert np.all(fields["types"] == 10)
    points = fields["Points"].reshape(-1, 3).astype(float)
    o, a, b, c = (points[column] for column in fields["connectivity"].reshape(-1, 4).T)
    volume = np.einsum("ij,ij->i", np.cross(a - o, b - o), c - o) / 6
    assert np.abs(np.sign(volume).sum()) > 0.99 * volume.size
    assert np.abs(volume).sum() == approx(ngs.Integrate(ngs.CF(1), pulled.mesh), rel=0.01)


@pytest.mark.slow
def test_invariants_in_the_vtu_are_those_of_its_stress(pulled):
    """Every von Mises stress is positive and that of the tensor beside it; principal ones are in order."""
    _, fields = vtu_arrays(vtu(pulled.displacement, BARS.materials))
    xx, yy, zz, xy, yz, xz = fields["stress_MPa"].reshape(-1, 6).T.astype(float)
    tensor = np.moveaxis(np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]), -1, 0)
    deviator = tensor - np.trace(tensor, axis1=1, axis2=2)[:, None, None] / 3 * np.eye(3)
    expected = np.sqrt(1.5 * (deviator**2).sum(axis=(1, 2)))
    size = np.abs(tensor).max()
    assert fields["von_mises_MPa"].min() >= 0
    assert fields["von_mises_MPa"] == approx(expected, rel=0, abs=1e-6 * size)
    principal_stresses = fields["principal_MPa"].reshape(-1, 3)
    assert np.diff(principal_stresses, axis=1).max() <= 0
    assert principal_stresses == approx(np.linalg.eigvalsh(tensor)[:, ::-1], rel=0, abs=1e-6 * size)


def test_file_of_another_kind_is_refused(pulled, tmp_path):
    with pytest.raises(ImpossiblePart, match=r"\.vtu"):
        pulled.write(tmp_path / "cage.vtk")


@pytest.mark.parametrize("forces", [np.zeros((8, 3)), np.full((8, 2), np.nan)], ids=["shape", "not finite"])
def test_forces_of_other_rollers_are_refused(cage, forces):
    with pytest.raises(ImpossiblePart, match=r"\(8, 2\)"):
        cage.under(forces)


def test_everything_close_to_rollers_is_said(tube, pressed):
    wide = replace(pressed.patches, width=0.1)
    sampled = WholeSolid(pressed, pressed)
    with pytest.raises(ImpossiblePart, match="close to a loaded roller"):
        extremes(sampled, "ring", clearing(tube.part, wide, pressed.forces, pressed.radius))


PLAIN = OuterRing(raceway_diameter=40e-3, thickness=4e-3, width=10e-3, elastic=STEEL, support=ClampedFace())
HOUSED = replace(PLAIN, support=Housing(thickness=5e-3, width=8e-3, elastic=STEEL))


@pytest.mark.parametrize(
    ("part", "sharp", "smooth"),
    [
        (CAGE, (5e-3, 40e-3), (3.9e-3, 40e-3)),
        (replace(CAGE, fillet=0.4e-3), (20.25e-3, 41.1e-3), (5e-3, 40e-3)),
        (SHAFT, (-6e-3, 29.8e-3), (0.0, 29.8e-3)),
        (PLAIN, (5e-3, 24e-3), (-5e-3, 24e-3)),
        (HOUSED, (4e-3, 24e-3), (5e-3, 22e-3)),
    ],
    ids=["cage", "fillets", "shaft", "ring", "housing"],
)
def test_sharp_edges_are_kept_away_from(part, sharp, smooth):
    x, radius = np.array([sharp, smooth]).T
    assert list(notches(part).clear(x, radius)) == [False, True]


def read_vtu(file):
    """Piece and arrays of a VTU file."""
    return vtu_arrays(file.read_bytes())


def vtu_arrays(content):
    """Piece and arrays of VTU with raw appended data: each begins with its length in bytes."""
    head, _, rest = content.partition(b'<AppendedData encoding="raw">')
    root = ET.fromstring(head + b"</VTKFile>")
    data = rest[rest.index(b"_") + 1 :]
    types = {"Float32": "<f4", "Int32": "<i4", "UInt8": "u1"}
    fields = {}
    for array in root.iter("DataArray"):
        start = int(array.get("offset"))
        length = int(np.frombuffer(data, "<u4", 1, start)[0])
        name = array.get("Name")
        fields[name] = np.frombuffer(data, types[array.get("type")], offset=start + 4, count=length // (
            np.dtype(types[array.get("type")]).itemsize))  # fmt: skip
    return next(root.iter("Piece")), fields
