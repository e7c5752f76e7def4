"""Another robot in our conventions: the same joint values put it where its own would."""

import pytest
from tests.comparison.trials import ARM, described_text, described_urdf, random_document
from tests.comparison.variants import urdf_of, variant
from tests.support.amount import usually

from kindsl.mechanics.rigid.body import lumped
from kindsl.robots.comparison.mechanical import compared_mechanics
from kindsl.robots.comparison.restated import restated


@pytest.mark.parametrize("seed", range(usually(20, 300)))
def test_a_variant_stands_exactly_on_the_robot(seed: int) -> None:
    described = described_text(random_document(seed))[0]
    ours = described.skeleton
    theirs = described_urdf(urdf_of(variant(ours, seed)), ours.is_floating)
    found = compared_mechanics(described, theirs)
    other = restated(ours, theirs.skeleton, found)
    assert set(other.joint_names) == set(ours.joint_names)
    for i, name in enumerate(ours.joint_names):
        k = other.joint_names.index(name)
        assert other.link_names[k] == ours.link_names[i]
        assert other.body_names[other.parents[k]] == ours.body_names[ours.parents[i]]
        assert other.placements[k].numbers == pytest.approx(ours.placements[i].numbers, abs=1e-9)
        one, two = (lumped([s.masses[n + 1]]) for s, n in ((ours, i), (other, k)))
        assert two.mass == pytest.approx(one.mass)
        assert two.com == pytest.approx(one.com, abs=1e-9)
        assert two.moments == pytest.approx(one.moments, rel=1e-6, abs=1e-9)


def test_what_matches_nothing_keeps_its_name_as_far_as_that_is_free() -> None:
    shorter = ARM.replace("children { lower via elbow }", "children {}")
    shorter = shorter[: shorter.index("link lower")] + shorter[shorter.index("r_joint shoulder") :]
    ours = described_text(shorter[: shorter.index("r_joint elbow")] + "}\n")[0]
    theirs = described_text(
        ARM.replace("link lower", "link upper_2").replace("lower via", "upper_2 via")
    )[0]
    other = restated(ours.skeleton, theirs.skeleton, compared_mechanics(ours, theirs))
    assert other.link_names == ("upper", "upper_2")
    assert other.placements == theirs.skeleton.placements
