"""Ball bearings from case file to summary and pictures, beside printed numbers."""

import json
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest
import xarray
from pytest import approx

import flexbearing
from flexbearing import explain, read
from flexbearing.api import check, read_case
from flexbearing.families import FAMILIES
from flexbearing.progress import Logged
from flexbearing.quantities.angular_contact import DRY_TORQUE
from flexbearing.report.output import text, write_figures
from flexbearing.runs import angular_contact
from quasidynamic import NotSolved
from tests.flexbearing.noted import codes, keys, texts
from tests.places import CONFIGS

BALLS = sorted(
    file.stem for stem in ("harris", "heras", "joshi", "rivera") for file in CONFIGS.glob(f"{stem}*.toml")
)
RIVERA, HARRIS = "rivera2021_7008", "harris218"
EQUATION_15 = "rolling_lines.spin=contact angle"
FEW = "fields.points=5"


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """Results by case and settings, each computed once."""
    place, known = tmp_path_factory.mktemp("balls"), {}

    def computed(name, *settings):
        if (name, settings) not in known:
            output = place / f"{len(known)}.h5"
            known[name, settings] = flexbearing.run(CONFIGS / f"{name}.toml", settings, output=output)
        return known[name, settings]

    return computed


# -- what the papers print ------------------------------------------------------------------------


@pytest.mark.parametrize("name", BALLS)
def test_every_case_that_comes_along_is_solved(run, name):
    result = run(name)
    numbers = result.summary()
    assert numbers["status"] == "converged"
    assert result.kind == numbers["kind"] == read_case(CONFIGS / f"{name}.toml").kind
    assert set(result.rigid) <= set(result.family.layout().datasets("block"))
    assert json.loads(json.dumps(numbers, allow_nan=False)) == numbers
    assert numbers["title"] in text(result)
    assert "converged" in text(result)


@pytest.mark.parametrize(
    ("name", "nominal", "loaded"),  # 1e-4 N m of one ball: total; spin, roll, total
    [
        ("fag", 95.0, (11.8, 67.4, 79.2)),
        ("ed20", 72.1, (59.8, 3.7, 63.5)),
        ("ex50", 58.9, (39.9, 13.9, 53.8)),
    ],
)
def test_joshi_table_2_by_either_reading(run, name, nominal, loaded):
    given = run(f"joshi2015_{name}").rigid
    assert 1e4 * given["ball_torque"][:, 0] == approx(np.full(3, nominal), rel=0.005)
    axial = "operation.load.axial=600 N" if name == "ed20" else "operation.load.axial=400 N"
    shared = run(f"joshi2015_{name}", "operation.mode=ring_load", axial).rigid
    found = [shared[part][0, 0] for part in ("spin_torque", "roll_torque", "ball_torque")]
    assert 1e4 * np.array(found) == approx(loaded, rel=0.01)
    assert "ring_load" in shared
    assert "ring_load" not in given


def test_joshi_four_point_bearing(run):
    numbers = run("joshi2015_fourpoint").summary()["rigid"]
    assert numbers["torque_Nm"]["inner"] == approx(1080.0, rel=0.01)
    assert numbers["torque_Nm"]["inner"] == approx(-numbers["torque_Nm"]["outer"], rel=1e-9)
    assert numbers["torque_parts_Nm"]["total"] == approx(numbers["torque_Nm"]["inner"], rel=1e-12)
    assert numbers["power_loss_W"] == approx(numbers["torque_Nm"]["inner"], rel=1e-7)  # at 1 rad/s
    assert numbers["loaded_balls"] == 156


HERAS = {  # ball speed over that of the ring, its angle [deg]
    "nominal": (33.0, 134.9),
    "a1": (33.3, 134.8),
    "a2": (43.4, 180.0),
    "a3": (33.3, 136.3),
    "b1": (32.8, 135.0),
    "b2": (45.5, 180.0),
    "b3": (43.9, 176.9),
}


@pytest.mark.parametrize("name", HERAS)
def test_heras_kinematics_of_table_4(run, name):
    values, (speed, angle) = run(f"heras2017_{name}").rigid, HERAS[name]
    assert values["ball_speed_ratio"] == approx([speed], rel=0.003)
    assert np.degrees(values["ball_attitude"]) == approx([angle], abs=0.4)


def test_rivera_counts_lines_by_their_equation_and_by_the_slip_field(run):
    printed, whole = run(RIVERA, EQUATION_15).rigid, run(RIVERA).rigid
    assert (printed["line_count"] == 2).all()
    assert (whole["line_count"] == 1).all()
    assert whole["line_parameter"][:, 0] == approx([1.27, 1.19], abs=0.005)
    weight = np.sin(printed["contact_angle"])  # Eq. (24)
    assert printed["spin_friction"] == approx((weight * printed["spin_torque"]).sum(), rel=1e-12)
    assert printed["spin_friction_by_lines"] / printed["spin_friction"] == approx(0.97, abs=0.01)


# -- what the datasets mean -----------------------------------------------------------------------


def test_hysteresis_adds_to_the_torque_of_both_rings(run):
    name, loss = "joshi2015_fag", "friction.hysteresis_loss=0.005"
    plain, more = run(name).rigid, run(name, loss).rigid
    added = np.array([1, -1]) * more["hysteresis_torque"][:, None]
    assert (more["hysteresis_torque"] > 0).all()
    assert more["ball_torque"] == approx(plain["ball_torque"] + added, rel=1e-12)


def test_circumferential_formula_is_named_and_told_apart(run):
    result = run("joshi2015_ed20", "friction.torque=circumferential")
    values = result.rigid
    assert values["ball_torque"] == approx(values["circumferential_torque"], rel=1e-12)
    assert values["ball_torque"][0, 0] / run("joshi2015_ed20").rigid["ball_torque"][0, 0] < 0.92
    assert any("circumferential formula" in note for note in texts(result))
    assert "circumferential formula" in text(result)


def test_torque_is_proportional_to_friction_and_power_to_speed(run):
    base = run("joshi2015_fag").rigid
    more = run("joshi2015_fag", "friction.coefficient=0.06", "operation.speed=3 rad/s").rigid
    assert more["torque"] == approx(base["torque"] / 2, rel=1e-9)
    assert more["power_loss"] == approx(base["power_loss"] * 1.5, rel=1e-9)
    assert more["slip_along"] == approx(base["slip_along"] * 3, rel=1e-6)
    across = base["slip_across"]
    assert more["slip_across"] == approx(across * 3, rel=1e-6, abs=1e-9 * np.abs(across).max())
    assert np.abs(across).max() > 0.0
    assert more["shear_along"] == approx(base["shear_along"] / 2, rel=1e-6, abs=1.0)


def test_friction_against_pressure_is_read_from_the_case(run, tmp_path):
    file = tmp_path / "curve.toml"
    constant = (CONFIGS / "joshi2015_fag.toml").read_text()
    curve = 'pressures = ["1 GPa", "2 GPa"]\ncoefficients = [0.2, 0.1]'
    file.write_text(constant.replace("coefficient = 0.12", curve))
    result = flexbearing.run(file, [FEW], output=tmp_path / "curve.h5")
    assert (result.rigid["friction_coefficient"] == 0.1).all()  # both contacts above 2 GPa
    assert any("outside the 1 to 2 GPa" in note for note in texts(result))


def test_fields_are_those_of_the_chosen_balls(run):
    values = run("joshi2015_fourpoint", "fields.balls=[3, 60]", FEW).rigid
    assert list(values["field_ball"]) == [3, 60]
    assert values["shear_along"].shape == (2, 2, 2, 5, 5)
    for place, ball in enumerate((3, 60)):
        loaded = values["contact_load"][ball] > 0
        assert ((np.ptp(values["field_across"][place], axis=(-1, -2)) > 0) == loaded).all()
        shear = np.hypot(values["shear_along"], values["shear_across"])[place]
        limit = values["friction_coefficient"][ball][..., None, None] * values["field_pressure"][place]
        assert shear == approx(limit, rel=1e-9)
        sides = [np.diff(values[f"field_{name}"][place], axis=axis)[:, :, 0, 0]
                 for name, axis in (("across", -2), ("along", -1))]  # fmt: skip
        force = values["field_pressure"][place].sum((-1, -2)) * sides[0] * sides[1]
        assert force[loaded] == approx(values["contact_load"][ball][loaded], rel=1e-6)


def test_axes_of_contacts_have_names(run):
    """Slip by the spin of a contact grows across it, so these are the axes that they are called."""
    result = run("heras2017_b1", FEW)
    with xarray.open_datatree(result.path, engine="h5netcdf") as tree:
        field = tree["rigid"]["field_pressure"]
        assert field.dims == ("chosen_ball", "diagonal", "race", "across", "along")
        assert list(field["chosen_ball"]) == [0]
        one = tree["rigid"].isel(chosen_ball=0, diagonal=0, race=0)
        assert (one["field_across"].diff("across") > 0).all()
        assert (one["field_along"].diff("along") > 0).all()
        assert (one["field_along"].diff("across") == 0).all()


def test_most_loaded_ball_is_drawn_unless_told(run):
    values = run("joshi2015_fourpoint").rigid
    assert values["field_ball"] == approx([values["contact_load"].sum((1, 2)).argmax()])


def test_balls_that_nothing_drives_are_gaps_and_make_no_torque(run):
    result = run("joshi2015_qj309", "operation.load.axial=0 N", "operation.load.radial_z=5 kN", FEW)
    values = result.rigid
    idle = ~(values["contact_load"][..., 0] > 0).any(1)  # on the inner ring
    assert 0 < idle.sum() < 10
    assert np.isnan(values["ball_motion"][idle]).all()
    assert np.isfinite(values["ball_motion"][~idle]).all()
    assert (values["ball_torque"][idle] == 0).all()
    assert any(f"{idle.sum()} of 10 balls" in note for note in texts(result))
    assert None in result.summary()["rigid"]["ball_speed_ratios"]


def test_rings_of_another_steel_soften_the_contacts(run, tmp_path):
    file = tmp_path / "soft.toml"
    soft = '\n[materials.outer_ring]\nyoungs_modulus = "100 GPa"\npoisson_ratio = 0.3\n\n[friction]'
    file.write_text((CONFIGS / "joshi2015_fag.toml").read_text().replace("\n[friction]", soft))
    found, stiff = flexbearing.run(file, [FEW], output=tmp_path / "soft.h5").rigid, run("joshi2015_fag").rigid
    assert found["peak_pressure"][..., 0] == approx(stiff["peak_pressure"][..., 0], rel=1e-12)
    assert (found["peak_pressure"][..., 1] < 0.9 * stiff["peak_pressure"][..., 1]).all()


def test_groove_radius_says_the_same_as_conformity(run):
    base = run("joshi2015_fag").rigid["torque"]
    text = (CONFIGS / "joshi2015_fag.toml").read_text()
    radius = 0.5225 * 4.76
    assert "conformity = 0.5225" in text
    changed = text.replace("conformity = 0.5225", f'radius = "{radius!r} mm"')
    file = Path(run("joshi2015_fag").path).with_name("radius.toml")
    file.write_text(changed)
    assert flexbearing.run(file, [FEW], output=file.with_suffix(".h5")).rigid["torque"] == approx(
        base, rel=1e-9
    )


def test_moments_and_tilts_say_about_which_point_they_are(run):
    for name, plane in ((RIVERA, "inner groove centres"), ("joshi2015_fourpoint", "ball centres")):
        result = run(name)
        entries = result.family.layout().datasets("block")
        for dataset in ("ring_load", "ring_displacement", "stiffness_matrix"):
            assert f"the point of the axis in the plane of the {plane}" in entries[dataset].meaning
    told = explain("operation.load.moment_y")
    assert "in the plane of the inner groove centres" in told
    assert "in the plane of the ball centres" in told


def test_held_ring_reports_the_load_it_takes(run):
    loaded = run(RIVERA)
    place = float(loaded.rigid["ring_displacement"][0])
    held = run(RIVERA, "operation.load.axial=0 N", f"operation.displacement.axial={place!r} m").rigid
    assert held["ring_load"][0] == approx(500.0, rel=1e-6)
    assert loaded.summary()["rigid"]["ring_displacement_um"][0] == approx(1e6 * place, rel=1e-12)


def test_reaction_where_the_ring_is_held_is_among_the_printed_results(run):
    held = run("6209", "operation.displacement.axial=10 um")
    shown = text(held).split("load or reaction, x")[1].split("\n")[0]
    assert shown.split()[0] == f"{held.rigid['ring_load'][0]:,.1f}"


SETTINGS = {
    "outer control": ("operation.control=outer",),
    "inner control": ("operation.control=inner",),
    "outer control, radial load": ("operation.control=outer", "operation.load.radial_z=300 N"),
    "thrust the other way": ("operation.load.axial=-500 N", "bearing.contact_angle=0 deg"),
    "no contact angle": ("bearing.contact_angle=0 deg", "rolling_lines.net_force=balanced"),
}


@pytest.mark.parametrize("settings", SETTINGS.values(), ids=SETTINGS)
def test_every_ball_on_both_races_has_rolling_lines(run, settings):
    result = run(RIVERA, *settings)
    both = (result.rigid["contact_load"] > 0).all(0)
    assert both.sum() >= 9
    assert np.isfinite(result.rigid["first_line"][:, both]).all()
    assert np.isfinite(result.rigid["slip_profile"][:, both]).all()
    assert not any(note.startswith("no pure rolling lines") for note in texts(result))


def test_balls_without_lines_are_counted_with_their_reason():
    case = read_case(CONFIGS / f"{RIVERA}.toml")
    (ended,) = angular_contact.solved([case], Logged())
    solution = ended["rigid"]
    assert isinstance(solution, angular_contact.Solution)
    some = replace(solution.contact, sliding=np.array([3, 4]), wide=np.array([7]))
    told = [note.text for note in angular_contact.notes(replace(solution, contact=some), ())]
    assert [note.split(":")[0] for note in told] == [
        "no pure rolling lines of 1 of 18 balls", "no pure rolling lines of 2 of 18 balls",
    ]  # fmt: skip


def test_contacts_that_leave_the_races_are_told(run):
    steep = run(RIVERA, "bearing.contact_angle=50 deg")
    (note,) = [note for note in texts(steep) if note.startswith("contacts reach ")]
    assert "up the inner race" in note
    assert f"{np.degrees(steep.rigid['contact_angle'][0]).max():.1f} deg" in note
    assert note in " ".join(text(steep).split())
    assert not any("contacts reach" in note for note in texts(run(RIVERA)))


def reached(values, ball, groove):
    """Height of the inner race up to which contacts reach [m], from the file alone."""
    ends = np.abs(values["contact_angle"][0]) + np.arcsin(2 * values["semi_axis_across"][0] / ball)
    return groove * (1 - np.cos(ends))


def carried(values):
    """Loads over those of whole ellipses under their peak pressure, inner contacts."""
    load, across, along, peak = (
        values[name][0] for name in ("contact_load", "semi_axis_across", "semi_axis_along", "peak_pressure")
    )
    return load / (peak * np.pi * across * along / 1.5)


def shoulder_notes(result):
    return [note for note in texts(result) if "shoulder" in note]


def test_contacts_on_a_given_shoulder_are_counted(run):
    leaning = ("bearing.contact_angle=30 deg", "operation.load.radial_z=400 N")
    shoulder = float(np.median(reached(run(RIVERA, *leaning).rigid, 7.938e-3, 0.52 * 7.938e-3)))
    cut = run(RIVERA, *leaning, f"bearing.inner.shoulder={shoulder!r} m")
    (note,), height = shoulder_notes(cut), reached(cut.rigid, 7.938e-3, 0.52 * 7.938e-3)
    over = int((height > shoulder).sum())
    assert 0 < over < 18
    assert note.startswith(f"{over} contacts are cut off on the shoulder of the inner race, ")
    assert f"{1e3 * shoulder:.4g} mm high: whole ellipses reach up to {1e3 * height.max():.4g} mm" in note
    assert f"the most cut one carries {carried(cut.rigid).min():.0%} of the load of a whole one" in note


def test_forces_of_cut_contacts_carry_the_ring(run):
    """Added up from what is stored, at the inner race, along the axis; loads and angles alone do not."""
    fast = run(HARRIS, "bearing.inner.shoulder=5 mm", "bearing.outer.shoulder=2 mm").rigid
    load, angle, aside = (fast[name][0] for name in ("contact_load", "contact_angle", "shoulder_force"))
    axial = load * np.sin(angle) + (fast["traction"][0] + aside) * np.cos(angle)
    assert axial.sum() == approx(fast["ring_load"][0], rel=1e-9)
    assert (load * np.sin(angle)).sum() != approx(fast["ring_load"][0], rel=1e-3)
    slow = run("joshi2015_qj309", "bearing.inner.shoulder=2.2 mm", "bearing.outer.shoulder=2.2 mm").rigid
    load, angle, aside = (slow[name][..., 0] for name in ("contact_load", "contact_angle", "section_force"))
    to_own_side = load * np.sin(angle) + aside * np.cos(angle)
    assert (to_own_side @ [1.0, -1.0]).sum() == approx(slow["ring_load"][0], rel=1e-9)


def test_given_shoulder_counts_instead_of_the_usual_one(run):
    """Contacts reach 5.85 mm up the inner race, more than a quarter of the ball, 3.03 mm up the outer one."""
    assert "0.263 ball diameters up the inner race" in shoulder_notes(run(HARRIS))[0]
    assert not shoulder_notes(run(HARRIS, "bearing.inner.shoulder=5.9 mm"))
    (note,) = shoulder_notes(run(HARRIS, "bearing.inner.shoulder=5.9 mm", "bearing.outer.shoulder=2 mm"))
    assert note.startswith("16 contacts are cut off on the shoulder of the outer race, 2 mm high")


def test_contacts_of_rigid_four_point_races_reach_over_their_shoulders(run):
    """A contact to 45 deg + a/r reaches sqrt(r^2 - s^2) - r cos of that above where the arches meet."""
    name, few = "heras2017_nominal", "fields.points=5"
    plain = run(name, few)
    radius = 0.5263158 * 30e-3
    aside = (radius - 15e-3) * np.sin(np.pi / 4)
    edge = np.pi / 4 + plain.rigid["semi_axis_across"][0, 0] / radius
    inner, outer = np.sqrt(radius**2 - aside**2) - radius * np.cos(edge)
    notes = shoulder_notes(plain)
    assert [note.split(",")[0] for note in notes] == [
        f"contacts reach {inner / 30e-3:.3g} ball diameters up the inner race",
        f"contacts reach {outer / 30e-3:.3g} ball diameters up the outer race",
    ]
    high, low = (f"bearing.{race}.shoulder={height!r} m" for race, height in
                 (("inner", float(inner) * 1.001), ("outer", float(outer) * 0.999)))  # fmt: skip
    (note,) = shoulder_notes(run(name, few, high, low))
    assert note.startswith("1 contacts are cut off on the shoulder of the outer race, ")


def test_balls_that_no_race_guides_are_told(run):
    light = run(RIVERA, "operation.load.axial=2 N")
    assert any("18 balls are loaded too lightly on the inner race" in n for n in texts(light))


def test_friction_too_low_for_the_gyroscopic_moment_is_told(run):
    result = run(RIVERA, "friction.coefficient=0.01")
    assert any("gyroscopic moment" in note for note in texts(result))
    assert not run(RIVERA).attributes["notes"]


def test_balls_that_leave_the_inner_race_are_gaps(run):
    result = run(RIVERA, EQUATION_15, "operation.load.radial_z=1000 N", "bearing.contact_angle=40 deg")
    values = result.rigid
    off = values["contact_load"][0] == 0
    assert 0 < off.sum() < 18
    for name in ("line_count", "first_line", "spin_torque", "slip_profile"):
        assert np.isnan(values[name][:, off]).all()
        assert np.isfinite(values[name][:, ~off]).all()
    assert any(f"{off.sum()} of 18 balls" in note for note in texts(result))


def test_balanced_net_force_reaches_the_lines(run):
    values = run(RIVERA, EQUATION_15, "rolling_lines.net_force=balanced").rigid
    force = values["net_friction"] * values["contact_load"]
    assert np.abs(values["net_friction"]).min() > 0
    assert force[0] == approx(force[1], rel=1e-9)


# -- endings --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "setting"),
    [("joshi2015_qj309", "operation.load.axial=0 N"), (RIVERA, "operation.load.axial=0 N")],
)
def test_ring_that_nothing_holds_is_not_solved_and_says_so(tmp_path, name, setting):
    result = flexbearing.run(CONFIGS / f"{name}.toml", [setting], output=tmp_path / "r.h5")
    assert result.attributes["status"] == "not solved"
    assert result.attributes["ending"] == "undetermined"
    assert result.summary()["rigid"] is None
    assert "NOT CONVERGED: not solved (undetermined)" in text(result)
    assert write_figures(result, tmp_path) == []


def test_ring_on_one_ball_names_the_azimuth_and_another_azimuth_holds_it(run):
    settings = "operation.load.radial_z=1 N", "operation.displacement.axial=0 um"
    message = run("catalogue/6208", *settings).attributes["message"]
    assert "3000 rpm" in message
    assert "another azimuth of the balls" in message
    other = run("catalogue/6208", *settings, "bearing.first_ball_azimuth=3 deg")
    assert other.attributes["status"] == "converged"


def test_load_beyond_small_contacts_is_not_solved():
    """The case is one that `check` accepts: its loads leave the law."""
    settings = ['operation.contact_loads=["1e9 N"]']
    check(CONFIGS / "joshi2015_fag.toml", settings)
    result = flexbearing.run(CONFIGS / "joshi2015_fag.toml", settings)
    assert (result.attributes["status"], result.attributes["ending"]) == ("not solved", "outside a law")
    assert "far too high" in result.attributes["message"]


@pytest.mark.parametrize(
    ("case", "settings", "code"),
    [
        ("harris218.toml", {
            "bearing.inner.radius": "300 mm", "bearing.outer.radius": "300 mm",
            "outputs.subsurface_stresses": True}, "no-subsurface-stresses"),
        ("harris218.toml", {"operation.inner_speed": "0 rpm", "friction.model": "fastsim"},
         "no-stick-and-slip"),
        ("joshi2015_qj309.toml", {
            "friction.contact_pressure": "offset", "friction.model": "fastsim",
            "operation.load.axial": "200 kN", "bearing.inner.shoulder": "2 mm",
            "bearing.outer.shoulder": "2 mm"}, "no-stick-and-slip"),
    ],
    ids=["ellipse too long", "at rest", "on the shoulder"],
)  # fmt: skip
def test_an_output_outside_its_law_is_absent_alone(case, settings, code):
    result = flexbearing.run(CONFIGS / case, settings)
    assert result.attributes["status"] == "converged"
    assert result.rigid["contact_load"].max() > 0
    assert code in codes(result, "outside validity")
    assert not {name for name in result.rigid if name.startswith(("subsurface", "stick"))}


# -- file and pictures ----------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["joshi2015_fourpoint", RIVERA])
def test_file_says_what_it_holds(run, name):
    result = run(name)
    table = result.family.layout().datasets("block")
    with h5py.File(result.path) as file:
        assert file.attrs["kind"] == result.kind
        assert [name for name in file if isinstance(file[name], h5py.Group)] == ["rigid"]
        rigid = file["rigid"]
        assert isinstance(rigid, h5py.Group)
        for dataset, item in rigid.items():
            assert item.attrs["units"] == table[dataset].unit
    again = read(result.path)
    assert again.flexible == {}
    assert again.iterations == ()


PICTURES = {
    "joshi2015_fourpoint": {"ball_loads", "ball_torques", "contacts_of_ball_138"},
    "heras2017_a3": {"contacts_of_ball_0"},
    RIVERA: {"ball_loads", "rolling_lines", "slip_profiles"},
}


@pytest.mark.parametrize("name", PICTURES)
def test_pictures_of_a_result(run, name):
    result = run(name)
    drawn = result.family.report().pictures()(result)
    assert drawn.keys() == PICTURES[name]
    assert all(result.attributes["title"] in figure.get_suptitle() for figure in drawn.values())


def test_one_panel_for_each_loaded_contact(run):
    (figure,) = FAMILIES["four_point_ball"].report().pictures()(run("heras2017_a3")).values()
    titles = [axes.get_title() for axes in figure.axes if axes.get_title()]
    assert [title.split(":")[0] for title in titles] == [
        "diagonal 1, inner race", "diagonal 1, outer race",
        "diagonal 2, inner race", "diagonal 2, outer race",
    ]  # fmt: skip
    (figure,) = FAMILIES["four_point_ball"].report().pictures()(run("heras2017_a1")).values()
    assert sum("race" in axes.get_title() for axes in figure.axes) == 2


def test_pictures_become_files(run, tmp_path):
    (file,) = write_figures(run("heras2017_a1"), tmp_path)
    assert file.stem.endswith("_contacts_of_ball_0")
    assert file.read_bytes()[:4] == b"\x89PNG"


COULOMB = ("operation.control=coulomb", "friction.coefficient=0.08")


def test_friction_decides_what_balls_do(run):
    """The 7008 bearing at 15 000 rpm, thrust alone: all balls alike, heat is the power of the shaft."""
    result = run(RIVERA, *COULOMB)
    values, numbers = result.rigid, result.summary()["rigid"]
    assert np.ptp(values["ball_attitude"]) < 1e-8
    assert 0 < np.abs(values["ball_yaw"]).max() < np.radians(0.5)
    assert (np.abs(values["traction"]) < 0.08 * values["contact_load"]).all()
    speed = 15000 * np.pi / 30
    assert values["friction_torque"] * speed == approx(values["friction_heat"].sum(), rel=1e-12)
    assert numbers["friction_torque_Nm"] == approx(float(values["friction_torque"]), rel=1e-12)
    assert numbers["ball_yaw_range_deg"] == approx(np.degrees(values["ball_yaw"][[0, -1]]), abs=1e-9)
    assert run(RIVERA).summary()["rigid"]["ball_yaw_range_deg"] is None
    assert "ball_yaw" not in run(RIVERA).rigid


@pytest.mark.sampled(2)
def test_contacts_stick_in_the_balance_on_half_the_cells_along_and_across():
    sticking = {"operation.control": "coulomb", "friction.model": "fastsim", "friction.cells": [24, 80]}
    case = read_case(CONFIGS / "harris218.toml", sticking)
    assert angular_contact.bearing(case).sticking == (12, 40)


@pytest.mark.parametrize("control", ["outer", "inner", "equal", "coulomb"])
def test_every_control_has_one_friction_torque_by_one_coefficient(run, control):
    """The heat over the speed; the sum of Eq. (24) is another number, by the same coefficient."""
    one, other = (
        run(RIVERA, f"operation.control={control}", f"friction.coefficient={friction}")
        for friction in (0.1, 0.05)
    )
    speed = 15000 * np.pi / 30
    torque, less = (result.rigid["friction_torque"] for result in (one, other))
    assert torque * speed == approx(one.rigid["friction_heat"].sum(), rel=1e-12)
    if control != "coulomb":
        assert less == approx(torque / 2, rel=1e-9)
        assert other.rigid["spin_friction"] == approx(one.rigid["spin_friction"] / 2, rel=1e-9)
    page = text(one)
    assert page.count(DRY_TORQUE) == 1
    assert "sum of spin torques, Rivera Eq. (24) " in page


def test_local_spin_makes_more_friction_of_fast_balls(run):
    rolling = ("bearing.contact_angle=0 deg", "operation.inner_speed=100 rpm")
    local, centre = (run(RIVERA, f"friction.spin={spin}", *rolling).rigid for spin in ("local", "centre"))
    assert 1.02 < local["friction_torque"] / centre["friction_torque"] < 1.04


OF_FRICTION = ("yaw of the ball's axis, smallest", DRY_TORQUE, "heat of friction of a ball, smallest")


def test_page_shows_the_yaw_only_where_friction_decides(run):
    decided, assumed = text(run(RIVERA, *COULOMB)), text(run(RIVERA))
    lines = [(row, line) for line in decided.splitlines() for row in OF_FRICTION if row in line]
    assert [row for row, _ in lines] == list(OF_FRICTION)
    numbers = run(RIVERA, *COULOMB).summary()["rigid"]
    torque, heat = numbers["friction_torque_Nm"], numbers["friction_heat_range_W"]
    shown = [float(line.partition(row)[2].split()[0]) for row, line in lines]
    assert shown == approx([numbers["ball_yaw_range_deg"][0], torque, heat[0]], rel=1e-3, abs=5e-4)
    assert OF_FRICTION[0] not in assumed
    assert all(row in assumed for row in OF_FRICTION[1:])
    assert "None" not in assumed


def test_balls_that_friction_hardly_holds_are_told(run):
    result = run(RIVERA, "operation.control=coulomb", "friction.coefficient=0.01")
    (note,) = [note for note in texts(result) if note.startswith("gyroscopic moment: ")]
    assert "does not hold the axes of 18 balls" in note
    assert f"{np.degrees(result.rigid['ball_attitude']).min():.1f} deg" in note
    assert not any(note.startswith("gyroscopic") for note in texts(run(RIVERA, *COULOMB)))


@pytest.mark.sampled(2)
@pytest.mark.parametrize("model", ["kalker", "fastsim"])
def test_a_case_with_stick_and_slip_stores_cells_and_their_error(run, model):
    """B1 with the load that meets the printed torque of full sliding: 2.76 N m of 3.08."""
    settings = [
        'operation.contact_loads=["9.40 kN", "0 N"]', "friction.spin=local", "friction.coefficient=0.13",
        f"friction.model={model}", "friction.cells=[20, 40]",
    ]  # fmt: skip
    result = run("heras2017_b1", *settings)
    values, numbers = result.rigid, result.summary()["rigid"]
    assert numbers["torque_Nm"]["inner"] == approx(2.76, rel=0.06)
    assert numbers["torque_Nm"]["inner"] == approx(-numbers["torque_Nm"]["outer"], rel=1e-9)
    assert 0.0 < numbers["torque_grid_error_Nm"] < 0.1
    assert 0.1 < numbers["largest_stick_share"] < 0.6
    assert values["field_stick"].shape[-2:] == values["shear_along"].shape[-2:] == (40, 20)
    assert values["field_stick"][0, 0, 0].mean() == approx(
        np.pi / 4 * values["stick_share"][0, 0, 0], abs=0.05
    )
    assert keys(result, "stick-and-slip") == {"friction.spin": "local"}
    (figure,) = FAMILIES["four_point_ball"].report().pictures()(result).values()
    assert len(figure.axes) == 11  # four maps of two contacts and three scales of colours


def test_full_sliding_stores_the_fields_of_stick_and_slip_but_no_error_of_cells(run):
    values = run("heras2017_b1", FEW).rigid
    other = run("heras2017_b1", "friction.model=fastsim", "friction.cells=[16, 16]").rigid
    assert {name for name in other if name.startswith(("field_", "slip_", "shear_"))} <= set(values)
    assert not values["field_stick"].any()
    assert not {"grid_error", "stick_share", "ball_turn"} & set(values)


def test_a_case_on_computed_pressure_stores_it_and_says_so(run):
    """A1 with the load of the nominal case of the paper: the ring moves, or both arcs are offset."""
    settings = ["friction.spin=local", "friction.model=fastsim", "friction.cells=[16, 32]"]
    hertz, offset, translation = (
        run("heras2017_a1", *settings, f"friction.contact_pressure={each}")
        for each in ("hertz", "offset", "translation")
    )
    torques = [each.summary()["rigid"]["torque_Nm"]["inner"] for each in (translation, hertz, offset)]
    assert torques == sorted(torques)
    assert torques[0] < 0.95 * torques[1]
    values = offset.rigid
    peak = values["field_pressure"][0, 0].max((1, 2))
    assert values["peak_pressure"][0, 0].tolist() == approx(peak.tolist(), rel=1e-12)
    assert keys(offset, "computed-pressure") == {"friction.contact_pressure": "offset"}
    assert "computed-pressure" not in codes(hertz)


def test_computed_pressure_ends_at_a_shoulder(run):
    """The same height ends contacts in notes alone where the pressure is that of Hertz."""
    shoulder = ["bearing.inner.shoulder=7 mm", "friction.model=fastsim", "friction.cells=[16, 32]"]
    hertz, cut = (
        run("heras2017_a1", *shoulder, f"friction.contact_pressure={each}") for each in ("hertz", "offset")
    )
    assert "as if the race continued" in shoulder_notes(hertz)[0]
    assert not [note for note in shoulder_notes(cut) if "inner race" in note]
    (note,) = [note for note in shoulder_notes(cut) if note.startswith("shoulders cut")]
    assert note.startswith("shoulders cut 1 contacts of the inner and 0 of the outer ring")
    peaks = cut.rigid["peak_pressure"][0, 0]
    assert f"{peaks[0] / 1e6:,.0f} MPa" in note
    assert peaks[0] > 1.05 * peaks[1]


@pytest.mark.parametrize("name", ["heras2017_b1", pytest.param(HARRIS, marks=pytest.mark.slow)])
def test_an_interface_that_shears_is_told(run, name):
    cells = ["friction.model=fastsim", "friction.cells=[16, 16]"]
    without, result = run(name, *cells), run(name, *cells, "friction.interface_compliance=1 um")
    (note,) = [note for note in result.summary()["notes"] if note["code"] == "interface-compliance"]
    assert "shears by 1 um" in note["text"]
    assert not any("interface" in text for text in texts(without))
    assert result.rigid["stick_share"].sum() > without.rigid["stick_share"].sum() + 0.05


@pytest.mark.slow
@pytest.mark.parametrize("model", ["fastsim", "kalker"])
def test_stick_moves_the_balance_of_balls_that_friction_moves(run, model):
    settings = ["operation.control=coulomb", "friction.spin=local"]
    sliding = run(HARRIS, *settings)
    result = run(HARRIS, *settings, f"friction.model={model}", "friction.cells=[16, 32]")
    changed = np.degrees(result.rigid["contact_angle"] - sliding.rigid["contact_angle"])
    assert np.all((changed[0] > 0.1) & (changed[0] < 0.3))
    assert np.all((changed[1] < -0.1) & (changed[1] > -0.4))
    left = result.summary()["rigid"]["largest_unbalanced_section_force"]
    assert left < (1e-6 if model == "fastsim" else 0.02)
    assert any("FASTSIM on 8 by 16 cells" in text for text in texts(result))


@pytest.mark.slow
def test_fast_balls_with_stick_and_slip_keep_their_balance(run):
    settings = ["operation.control=outer", "operation.load.radial_z=3 kN", "friction.spin=local"]
    sliding = run(HARRIS, *settings)
    result = run(HARRIS, *settings, "friction.model=kalker", "friction.cells=[16, 32]")
    values, numbers = result.rigid, result.summary()["rigid"]
    for name in ("contact_load", "contact_angle", "ball_attitude", "orbital_speed"):
        assert values[name] == approx(sliding.rigid[name], rel=1e-12)
    assert 0.97 * sliding.rigid["friction_torque"] < values["friction_torque"]
    assert values["friction_torque"] < sliding.rigid["friction_torque"]
    assert values["friction_heat"].sum() == approx(values["friction_torque"] * 10000 * np.pi / 30, rel=1e-9)
    assert 0.0 < numbers["torque_grid_error_Nm"] < 0.01 * numbers["friction_torque_Nm"]
    assert values["field_ball"] == values["contact_load"].sum(0).argmax()
    assert values["field_stick"].shape == (2, 32, 16)
    codes = {note["code"] for note in result.summary()["notes"]}
    assert {"stick-and-slip", "kept-motion"} <= codes
    assert keys(result, "stick-and-slip") == {"friction.spin": "local"}
    assert any(f"{100 * values['unbalanced_moment'].max():.1f}%" in text for text in texts(result))
    force = np.abs(values["unbalanced_force"]).max()
    assert numbers["largest_unbalanced_force"] == approx(force)
    assert any(f"along the orbit of up to {100 * force:.1f}%" in text for text in texts(result))
    figure = FAMILIES[result.attributes["kind"]].report().pictures()(result)["contacts_of_ball_0"]
    assert len(figure.axes) == 11  # four maps of two contacts and three scales of colours


def test_fast_balls_in_full_sliding_store_neither_cells_nor_stick(run):
    values = run(HARRIS).rigid
    assert not {"field_stick", "field_ball", "grid_error", "stick_share", "unbalanced_moment"} & set(values)


def test_friction_without_a_balance_leaves_the_torque_out_and_the_rest_there(monkeypatch):
    def unbalanced(*_):
        raise NotSolved("1 of 16 balls found no balance of friction", "iteration limit")

    monkeypatch.setattr("quasidynamic.outcome.angular_contact_state.guided_motion", unbalanced)
    result = flexbearing.run(CONFIGS / "harris218.toml")
    assert result.attributes["status"] == "converged"
    assert "friction_torque" not in result.rigid
    assert result.rigid["contact_load"].max() > 0
    assert "no-friction-torque" in codes(result)


def test_the_outer_ring_turns_about_x_as_seen_from_slow_balls():
    """An inner ring that turns towards growing azimuth turns about -x, and so does the cage of its balls."""
    result = flexbearing.run(CONFIGS / "heras2017_a1.toml")
    speed = result.attributes["case_si"]["operation"]["speed"]
    orbit = 0.5 * speed * (1 - 0.03 * np.cos(np.radians(45.0)))
    assert result.rigid["ball_motion"][:, 0] == approx(orbit, rel=2e-3)
