"""Links as bodies: what is drawn of each, and what is said of it."""

import math
from dataclasses import replace

import pytest
from tests.preview.robots import ARM, EXAMPLES, plain_robot, skeleton_in, skeleton_of
from tests.support.documents import all_documents

from kindsl.judgement.analysis.analysis import analyse
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.robots.scene.picture import picture
from kindsl.robots.scene.size import extent
from kindsl.robots.scene.solids import (
    STEP,
    SUNK,
    Doubt,
    filling_radius,
    link_solids,
    shell_factor,
    usual_density,
)

SHARES = [k / 1000 for k in range(1001)]
QUADRUPED = (EXAMPLES / "quadruped.kindsl").read_text()


def solids(skeleton):
    return dict(zip(skeleton.body_names, link_solids(skeleton, extent(skeleton)), strict=True))


@pytest.mark.parametrize("file", all_documents())
def test_every_document_can_be_drawn_as_bodies(file):
    analysis = analyse(file.read_text())
    shown = picture(analysis.model, analysis.context.values, None).skeleton
    for solid in solids(shown).values():
        assert 0.0 < solid.bone < math.inf
        assert solid.drum >= solid.bone * 0.99 or solid.drum >= extent(shown).radius


def test_an_honest_robot_is_sound_and_each_link_told_from_its_parent():
    found = solids(skeleton_of(QUADRUPED))
    assert {solid.look for solid in found.values()} == {"sound"}
    assert all(solid.core for solid in found.values())
    assert found["LF_hip"].is_shaded != found["LF_thigh"].is_shaded
    assert found["LF_hip"].bone > found["LF_shank"].bone


def test_a_body_looks_as_the_linter_judges_it():
    skeleton = skeleton_of(QUADRUPED)
    doubtful, proved = Doubt("KD311", "of lead", False), Doubt("KD302", "no body", True)
    doubts = {"LF_hip": (doubtful,), "LF_thigh": (proved, doubtful)}
    found = dict(
        zip(skeleton.body_names, link_solids(skeleton, extent(skeleton), doubts), strict=True)
    )
    assert {name: solid.doubts for name, solid in found.items() if solid.doubts} == doubts
    looks = {name: solid.look for name, solid in found.items() if solid.look != "sound"}
    assert looks == {"LF_hip": "doubtful", "LF_thigh": "impossible"}


@pytest.mark.parametrize(
    ("mass", "moments", "is_oversized", "look"),
    [(0.6, 2.0, True, "glass"), (60.0, 20.0, False, "glass"), (60.0, 0.3, False, "sound")],
)
def test_a_body_larger_than_the_robot_does_not_hide_it(mass, moments, is_oversized, look):
    skeleton, doubt = skeleton_of(QUADRUPED), Doubt("KD311", "of gas", False)
    body = MassDistribution(mass, (0.0, 0.0, 0.0), (*(3 * [moments]), 0.0, 0.0, 0.0))
    found = solids(with_body(skeleton, "LF_thigh", body))
    assert [solid.is_oversized for solid in found.values()].count(True) == is_oversized
    assert (found["LF_thigh"].is_oversized, found["LF_thigh"].look) == (is_oversized, look)
    whole = with_body(skeleton, "LF_thigh", body)
    doubted = link_solids(whole, extent(whole), {"LF_thigh": (doubt,)})
    assert [solid.is_oversized for solid in doubted].count(True) == (look == "glass")


@pytest.mark.parametrize("share", [0.9, 0.5, 0.1, 0.01])
def test_a_shell_has_the_mass_and_the_inertia_of_the_solid(share):
    factor = shell_factor(share)
    # Of its inner surface, as a share of the outer one, from its mass.
    c = (1.0 - share / factor**3) ** (1 / 3)
    assert factor**2 * (1.0 - c**5) / (1.0 - c**3) == pytest.approx(1.0, rel=1e-6)


def test_what_is_as_dense_as_usual_is_no_shell():
    assert shell_factor(1.0) == shell_factor(3.0) == 1.0


def test_a_link_of_unknown_mass_has_bones_alone():
    skeleton = skeleton_of(QUADRUPED)
    found = link_solids(skeleton, extent(skeleton), unknown={"LF_thigh"})
    at = skeleton.body_names.index("LF_thigh")
    assert found[at].core is None
    assert found[at].look == "sound"


def test_densities_go_in_steps():
    skeleton = skeleton_in(plain_robot(12, 3))
    before = usual_density(skeleton.masses)
    masses = [body._replace(mass=1.0001 * body.mass) for body in skeleton.masses]
    assert usual_density(masses) == before


@pytest.mark.parametrize("ends", [[], [(0.0, 0.0, 0.5)], [(0.3, 0.0, 0.0), (0.0, 0.4, 0.0)]])
def test_bones_have_the_volume_of_the_mass(ends):
    radius = filling_radius(ends, 0.002)
    length = sum(math.hypot(*end) for end in ends)
    assert math.pi * radius**2 * length + 4 / 3 * math.pi * radius**3 == pytest.approx(0.002)


def ball(radius, center, mass=2.0):
    """Return a uniform ball, its moments about the frame's origin."""
    x, y, z = center
    own = 0.4 * mass * radius**2
    moments = (y * y + z * z, x * x + z * z, x * x + y * y)
    products = (mass * x * y, mass * x * z, mass * y * z)
    a, b, c = (own + mass * moment for moment in moments)
    return MassDistribution(mass, center, (a, b, c, *products))


def with_body(skeleton, name, body):
    masses = list(skeleton.masses)
    masses[skeleton.body_names.index(name)] = body
    return skeleton.with_masses(masses)


@pytest.mark.parametrize("below", [-0.1, 0.9, 1.1, 3.0])
@pytest.mark.parametrize("radius", [0.1, 0.15])
def test_a_sound_body_well_below_the_ground_is_of_glass(below, radius):
    skeleton = skeleton_of(QUADRUPED)
    measures = extent(skeleton)
    name = "LF_shank"
    pose = skeleton.zero_poses[skeleton.body_names.index(name)]
    lowest = measures.ground - below * SUNK * measures.size
    center = pose.inverse().point((0.1, 0.2, lowest + radius))
    body = ball(radius, center)
    found = solids(with_body(skeleton, name, body))[name]
    assert found.core.semi_axes == pytest.approx((radius,) * 3)
    assert (found.look == "glass") is (below > 1.0), found


def test_the_body_of_a_light_fixed_base_is_left_out():
    for is_floating in (False, True):
        skeleton = replace(skeleton_of(ARM), is_floating=is_floating)
        light = with_body(skeleton, skeleton.body_names[0], ball(2.0, (0.0, 0.0, 0.0)))
        assert (link_solids(light, extent(light))[0].core is not None) is is_floating


def test_the_body_of_a_placeholder_is_left_out():
    skeleton = skeleton_of(QUADRUPED)
    total = sum(body.mass for body in skeleton.masses)
    for share, is_drawn in ((1e-4, False), (1e-2, True)):
        light = ball(10.0 * share ** (1 / 3), (0.0, 0.0, 0.0), share * total)
        found = solids(with_body(skeleton, "LF_shank", light))["LF_shank"]
        assert (found.core is not None) is is_drawn
    small = ball(0.01, (0.0, 0.0, -0.1), 4e-3)
    assert small.mass < 1e-3 * total
    assert solids(with_body(skeleton, "LF_shank", small))["LF_shank"].core is not None


def test_what_is_said_of_a_link_without_body_is_said_of_its_bones():
    skeleton = with_body(skeleton_of(QUADRUPED), "LF_shank", ball(1.0, (1.0, 0.0, 0.0), -0.6))
    doubts = {"LF_shank": (Doubt("KD303", "mass of 'LF_shank' is negative", True),)}
    at = skeleton.body_names.index("LF_shank")
    found = link_solids(skeleton, extent(skeleton), doubts)[at]
    assert (found.core, found.look, found.doubts) == (None, "impossible", doubts["LF_shank"])


def scaled(skeleton, scale):
    """Return a robot of the same densities, all lengths some times as long."""

    def pose(old):
        return old._replace(translation=tuple(scale * x for x in old.translation))

    def body(old):
        moments = tuple(scale**5 * m for m in old.moments)
        return MassDistribution(scale**3 * old.mass, tuple(scale * x for x in old.com), moments)

    def made(old):
        parts = (p._replace(pose=pose(p.pose), mass=p.mass and body(p.mass)) for p in old.parts)
        return old._replace(parts=tuple(parts), placement=pose(old.placement))

    return replace(skeleton, bodies=tuple(map(made, skeleton.bodies)))


@pytest.mark.parametrize("scale", [STEP**-20, STEP**20])
@pytest.mark.parametrize(
    "file", [EXAMPLES / "quadruped.kindsl", EXAMPLES / "industrial_arm.kindsl"]
)
def test_a_robot_of_any_size_looks_the_same(file, scale):
    analysis = analyse(file.read_text())
    skeleton = picture(analysis.model, analysis.context.values, None).skeleton
    large = ball(2.05 * extent(skeleton).size, (0.0, 0.0, 0.0), 1.0)
    skeleton = with_body(skeleton, skeleton.body_names[-1], large)
    larger = link_solids(scaled(skeleton, scale), extent(scaled(skeleton, scale)))
    assert larger[-1].is_oversized
    for small, large in zip(link_solids(skeleton, extent(skeleton)), larger, strict=True):
        assert large.look == small.look
        assert large.is_oversized == small.is_oversized
        assert [large.bone, large.drum] == pytest.approx([scale * small.bone, scale * small.drum])
        assert len(large.strut) == len(small.strut)
        for end, other in zip(large.strut, small.strut, strict=True):
            assert end == pytest.approx([scale * x for x in other], abs=1e-9)


@pytest.mark.parametrize("center", [(0.3, 0.0, -0.1), (0.0, 0.2, 0.3), (0.02, 0.0, -0.05)])
def test_a_body_beside_its_bones_hangs_on_the_shortest_strut(center):
    skeleton = skeleton_of(QUADRUPED)
    measures = extent(skeleton)
    at = skeleton.body_names.index("LF_thigh")
    (bone,) = measures.segments[at]
    ways = [(math.dist([share * x for x in bone.end], center), share) for share in SHARES]
    length, share = min(ways)
    for radius, is_held in ((0.9 * length, True), (1.1 * length, False)):
        found = solids(with_body(skeleton, "LF_thigh", ball(radius, center)))["LF_thigh"]
        assert bool(found.strut) is is_held
        if is_held:
            assert found.strut[0] == pytest.approx([share * x for x in bone.end], abs=2e-3)
            assert found.strut[1] == pytest.approx(center)


def test_a_bone_stays_beneath_the_surface_of_its_body():
    skeleton = skeleton_of(QUADRUPED)
    unit = extent(skeleton).radius
    for radius, bone in ((0.2, 0.55), (1.5, 0.85 * 1.5), (30.0, 4.0)):
        body = ball(radius * unit, (0.0, 0.0, -0.1), 50.0)
        found = solids(with_body(skeleton, "LF_thigh", body))
        assert found["LF_thigh"].bone == pytest.approx(bone * unit)
        # The drum stands out of the thicker of its bones, as far as they are alike.
        thin, thick = sorted((bone, found["LF_hip"].bone / unit))
        drum = max(1.0, 1.15 * min(thick, 2.5 * thin))
        assert found["LF_thigh"].drum == pytest.approx(drum * unit)


def test_a_bone_is_as_thick_as_tubes_of_the_mass_but_less():
    skeleton = skeleton_of(QUADRUPED)
    measures = extent(skeleton)
    at = skeleton.body_names.index("LF_thigh")
    (bone,) = measures.segments[at]
    for mass in (1.0, 2.0, 4.0):
        heavy = with_body(skeleton, "LF_thigh", ball(0.2, (0.0, 0.0, -0.1), mass))
        full = filling_radius([bone.end], mass / usual_density(heavy.masses))
        assert 0.55 * measures.radius < 0.6 * full < 4.0 * measures.radius
        assert link_solids(heavy, measures)[at].bone == pytest.approx(0.6 * full)


@pytest.mark.parametrize(("density", "usual"), [(100.0, 300.0), (1e3, 1e3), (1e4, 3e3)])
def test_the_usual_density_is_that_of_things_people_build(density, usual):
    body = ball(0.1, (0.0, 0.0, 0.0), density * 4.0 / 3.0 * math.pi * 1e-3)
    assert usual_density([body, body]) == pytest.approx(usual, rel=0.06)
