"""`kindsl info`."""

import json
from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.cli.samples import GOOD, INTEGER, UNBOUND, arm


def test_tree_and_masses(kindsl: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(GOOD)
    told = kindsl("info", "a.kindsl")
    assert told.status == 0
    assert told.out == (
        "arm: fixed base, 2 degrees of freedom, 3 kg\n"
        "\n"
        "link         id  joint                mass  frames\n"
        "base          0                       1 kg\n"
        "└─ upper      1  shoulder  revolute   2 kg\n"
        "   └─ lower   2  elbow     prismatic  1 kg  tip\n"
        "\n"
        "robcogen reads it\n"
        "robcogen2 reads it\n"
        "\n"
        "health  good\n"
    )


def test_json(kindsl: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(arm(reach="length", mass="m", floating=True))
    facts = json.loads(kindsl("info", "a.kindsl", "--output-format", "json", "--param", "m=2").out)
    assert (facts["robot"], facts["floating"], facts["dof"], facts["mass"]) == ("arm", True, 8, 4.0)
    assert [(b["name"], b["id"], b["parent"], b["joint"]) for b in facts["links"]] == [
        ("upper", 1, "base", "shoulder"),
        ("lower", 2, "upper", "elbow"),
    ]
    length, mass = sorted(facts["parameters"], key=lambda p: str(p["name"]))
    assert (length["kind"], length["value"], length["origin"]) == ("length", None, None)
    assert (mass["kind"], mass["value"], mass["origin"]) == ("dynamics", 2.0, "--param")
    assert [use["line"] for use in length["uses"]] == [21]


def without_inertia(text: str) -> str:
    """Return a document whose last link has no inertia."""
    start = text.rindex("inertia_params")
    return text[:start] + text[text.index("}", start) + 1 :]


@pytest.mark.parametrize(
    ("text", "known", "reason"),
    [
        (arm(mass="m"), 1.0, "the parameter 'm' has no value"),
        (arm(mass=""), 1.0, "link 'upper' has no mass"),
        (arm(mass="1.0/0.0"), 1.0, "mass of 'upper' is not a number"),
        (arm(mass="2.0 -"), 1.0, "mass of 'upper' is not a number"),
        (without_inertia(GOOD), 2.0, "link 'lower' has no mass"),
        (GOOD.replace("link lower {", "link other {"), 3.0, "there is no link 'lower'"),
    ],
)
def test_a_part_of_the_mass_is_not_told_as_the_whole(
    kindsl: Runner, folder: Path, text: str, known: float, reason: str
) -> None:
    (folder / "a.kindsl").write_text(text)
    facts = json.loads(kindsl("info", "a.kindsl", "--output-format", "json").out)
    assert (facts["mass"], facts["known_mass"]) == (None, known)
    assert [one["reason"] for one in facts["missing_masses"]] == [reason]
    head = kindsl("info", "a.kindsl").out.splitlines()[0]
    assert head.endswith(f"freedom, at least {known:g} kg ({reason})")
    card = kindsl("card", "a.kindsl").out
    assert f"mass at least {known:g} kg ({reason})" in card.replace("\\", "")


def test_a_whole_mass_lacks_nothing(kindsl: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(GOOD)
    facts = json.loads(kindsl("info", "a.kindsl", "--output-format", "json").out)
    assert (facts["mass"], facts["known_mass"], facts["missing_masses"]) == (3.0, 3.0, [])


def test_nothing_known_is_no_mass_at_all(kindsl: Runner, folder: Path) -> None:
    text = without_inertia(without_inertia(GOOD))
    (folder / "a.kindsl").write_text(text)
    head = kindsl("info", "a.kindsl").out.splitlines()[0]
    assert head.endswith("freedom, mass unknown (link 'upper' has no mass; 1 more missing)")


def test_unbound_parameters_are_told(kindsl: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(UNBOUND)
    (row,) = (r for r in kindsl("info", "a.kindsl").out.splitlines() if r.startswith("length"))
    assert row.split() == ["length", "length", "-", "nothing", "21:32"]


def test_broken_documents_show_what_is_there(kindsl: Runner, folder: Path) -> None:
    loop = GOOD.replace("children {}", "children { upper via shoulder }")
    for text in (loop, GOOD[:400], INTEGER, "link a {"):
        (folder / "a.kindsl").write_text(text)
        told = kindsl("info", "a.kindsl")
        assert told.status == 0
        assert "see kindsl lint" in told.err
    (folder / "a.kindsl").write_text(GOOD.replace("children { lower via elbow }", "children {}"))
    assert "? lower" in kindsl("info", "a.kindsl").out


def test_unreadable(kindsl: Runner, folder: Path) -> None:
    told = kindsl("info", "missing.kindsl")
    assert (told.status, told.out) == (2, "")
    assert told.err == "missing.kindsl: error: no such file or folder\n"
    (folder / "kindsl.toml").write_text("x = 1\n")
    (folder / "a.kindsl").write_text(GOOD)
    told = kindsl("info", "a.kindsl")
    assert told.status == 2
    assert told.err.startswith("kindsl.toml:1:1: error: unknown key 'x'")


def test_health_tells_a_verdict_and_why(kindsl: Runner, folder: Path) -> None:
    (folder / "good.kindsl").write_text(GOOD)
    (folder / "bad.kindsl").write_text(GOOD.replace("mass = 2.0", "mass = -2.0", 1))
    health = json.loads(kindsl("info", "good.kindsl", "--output-format", "json").out)["health"]
    assert (health["verdict"], health["findings"]) == ("good", [])
    bad = json.loads(kindsl("info", "bad.kindsl", "--output-format", "json").out)["health"]
    assert bad["verdict"] == "broken"
    assert bad["subjects"]["inertia"]["error"] == 1
    text = kindsl("info", "bad.kindsl").out
    assert "health" in text and "[KD303]" in text
