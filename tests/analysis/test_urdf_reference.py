"""Moments of a URDF that are about the origins of its links, all of them."""

import pytest
from tests.analysis.test_urdf_in_place import joint, link, robot

from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.text.edits import apply_edits

# Rods along z: mass, length; the CoM is in the middle.
RODS = {"upper": (2.0, 0.4), "lower": (1.5, 0.3), "hand": (0.5, 0.2)}


def arm(factors: dict[str, float], unit: float = 1.0) -> str:
    """Return an arm whose rods have so many twelfths of `m l²` across, in a unit of kg·m²."""
    blocks, above = [], "base"
    for name, (mass, length) in RODS.items():
        across = factors[name] / 12.0 * mass * length**2 / unit
        along = 0.001 / unit
        tensor = f'ixx="{across:.6f}" ixy="0" ixz="0" iyy="{across:.6f}" iyz="0" izz="{along:.6g}"'
        origin = f'<origin xyz="0 0 {length / 2}"/>'
        blocks += [link(name, tensor, f"{mass}", origin), joint(f"to_{name}", above, name)]
        above = name
    return robot(*blocks)


def test_moments_about_the_links_origins_are_told_once() -> None:
    text = arm(dict.fromkeys(RODS, 4.0))
    (found,) = (each for each in analyse(text).findings if each.code == "KD306")
    assert "'upper' and 2 more links would most likely be about the origins" in found.message
    assert found.severity == "warning"
    assert text.count("\n", 0, found.start) + 1 == text[: text.index("<inertial>")].count("\n") + 1


@pytest.mark.parametrize("honest", [*RODS, ""])
def test_one_link_that_cannot_be_so_speaks_for_all(honest: str) -> None:
    factors = {name: 1.0 if honest in ("", name) else 4.0 for name in RODS}
    assert "KD306" not in [each.code for each in analyse(arm(factors)).findings]


def test_copies_of_one_link_count_once() -> None:
    text = arm(dict.fromkeys(RODS, 4.0))
    start = text.index("<inertial>")
    inertial = text[start : text.index("</inertial>", start)]
    parts = text.split("<inertial>")
    same = parts[0] + "".join(inertial + part[part.index("</inertial>") :] for part in parts[1:])
    assert "KD306" not in [each.code for each in analyse(same).findings]


@pytest.mark.parametrize("unit", [("g·mm²", 1e-9), ("g·cm²", 1e-7), ("kg·cm²", 1e-4)])
@pytest.mark.parametrize(("twelfths", "codes"), [(1.0, ["KD308"]), (4.0, ["KD308", "KD306"])])
def test_the_unit_of_all_moments_is_told_beside_their_reference(
    unit: tuple[str, float], twelfths: float, codes: list[str]
) -> None:
    name, value = unit
    found = analyse(arm(dict.fromkeys(RODS, twelfths), value)).findings
    assert [each.code for each in found] == codes
    assert found[0].message == (
        f"inertias of all 3 moving links would be consistent if the moments were in {name}"
    )
    assert found[0].fix is not None and found[0].severity == "warning"
    text = apply_edits(arm(dict.fromkeys(RODS, twelfths), value), found[0].fix.edits)
    assert [each.code for each in analyse(text).findings] == codes[1:]


def test_a_unit_that_all_moments_are_in_is_fixed_where_no_link_alone_is_sure(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for name, (mass, length) in RODS.items():
        monkeypatch.setitem(RODS, name, (8.0 * mass, length))
    (found,) = analyse(arm(dict.fromkeys(RODS, 2.0), 1e-7)).findings
    assert found.code == "KD308" and found.fix is not None
    assert found.probability is not None and found.probability < 0.95
