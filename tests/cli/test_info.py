"""`kindsl info`."""

import json
from pathlib import Path

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
