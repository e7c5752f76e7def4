"""Links as bodies: what is drawn of each, and what is said of it."""

import math
from dataclasses import replace

import pytest
from tests.preview.robots import EXAMPLES, plain_robot, skeleton_in, skeleton_of
from tests.support.documents import all_documents

from kindsl.analysis.analysis import analyse
from kindsl.rigid.body import MassDistribution
from kindsl.rules.inertia.shapes import shape_verdicts
from kindsl.scene.picture import picture
from kindsl.scene.size import extent
from kindsl.scene.solids import filling_radius, link_solids, shell_factor, usual_density

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


def test_what_no_body_has_is_impossible():
    skeleton = skeleton_of(QUADRUPED)
    masses = list(skeleton.masses)
    masses[5] = MassDistribution(0.6, (0.0, 0.0, 0.0), (0.001, 0.001, 0.01, 0.0, 0.0, 0.0))
    wrong = link_solids(replace(skeleton, masses=tuple(masses)), extent(skeleton))
    assert wrong[5].look == "impossible"
    assert [solid.look for solid in wrong].count("impossible") == 1


def test_an_impossible_body_has_its_rule_and_its_sentence():
    skeleton = skeleton_of(QUADRUPED)
    masses = list(skeleton.masses)
    masses[5] = MassDistribution(0.6, (0.0, 0.0, 0.0), (-0.001, 0.001, 0.01, 0.0, 0.0, 0.0))
    masses[6] = MassDistribution(0.6, (0.0, 0.0, 0.0), (0.001, 0.001, 0.01, 0.0, 0.0, 0.0))
    masses[7] = masses[7]._replace(mass=-0.6)
    found = link_solids(replace(skeleton, masses=tuple(masses)), extent(skeleton))
    told = [[(doubt.word, doubt.code) for doubt in solid.doubts] for solid in found[5:8]]
    assert told == [[("impossible", code)] for code in ("KD301", "KD302", "KD303")]
    assert "'LF_thigh'" in found[5].doubts[0].sentence


@pytest.mark.parametrize("file", all_documents())
def test_a_body_is_judged_as_the_rules_judge_it(file):
    analysis = analyse(file.read_text())
    model, context = analysis.model, analysis.context
    shown = picture(model, context.values, None).skeleton
    for name, solid in solids(shown).items():
        ours = {doubt.code for doubt in solid.doubts if doubt.word != "impossible"}
        body = model.body_named[name]
        theirs = {v.code for v in shape_verdicts(body, model.tree.joints_on(body), context)}
        assert ours <= theirs
        if solid.core is not None and solid.look != "impossible":
            assert ours == theirs
        assert (solid.look == "doubtful") <= bool(ours)


def test_a_judged_body_as_large_as_the_robot_waits_to_be_asked_for():
    skeleton = skeleton_of(QUADRUPED)
    masses = list(skeleton.masses)
    masses[5] = MassDistribution(0.6, (0.0, 0.0, 0.0), (2.0, 2.0, 2.0, 0.0, 0.0, 0.0))
    found = link_solids(replace(skeleton, masses=tuple(masses)), extent(skeleton))
    assert [solid.is_oversized for solid in found].count(True) == 1
    assert found[5].look == "doubtful"
    assert found[5].doubts[0].code == "KD311"


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
    found = link_solids(skeleton, extent(skeleton), {"LF_thigh"})
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
