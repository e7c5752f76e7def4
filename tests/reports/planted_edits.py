"""Edits of a document as people make them, each with what a review must say of it."""

import re
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import NamedTuple

EXAMPLES = Path(__file__).parents[2] / "examples"
TEXT = (EXAMPLES / "quadruped.kindsl").read_text()
_LEGS = ("LF", "RF", "LH", "RH")


class Planted(NamedTuple):
    """An edited document, and rows of the review's tables that must be there.

    Attributes:
        text: The document.
        changes: Kind, name and a part of the change.
        numbers: Name, which number, and the remark.
    """

    text: str
    changes: tuple[tuple[str, str, str], ...]
    numbers: tuple[tuple[str, str, str], ...] = ()


def _in_block(text: str, head: str, old: str, new: "str | Callable[[re.Match[str]], str]") -> str:
    """Replace once in the block that begins so."""
    start = text.index(head)
    end = text.index("\n}", start)
    block = re.sub(old, new, text[start:end], count=1)
    assert block != text[start:end], head
    return text[:start] + block + text[end:]


def _turned_sign(found: re.Match[str]) -> str:
    return found[0][1:] if found[0].startswith("-") else f"-{found[0]}"


def _renamed(text: str, old: str, new: str) -> str:
    return re.sub(rf"\b{old}\b", new, text)


def moved_joint(leg: str) -> Planted:
    text = _in_block(TEXT, f"r_joint {leg}_KFE", r"translation = \(0\.0,", "translation = (0.05,")
    number = (f"{leg}_KFE", "translation x", "")
    return Planted(text, (("joint frame", f"{leg}_KFE", "moved 50 mm"),), (number,))


def swapped_joint_sign(leg: str) -> Planted:
    text = _in_block(TEXT, f"r_joint {leg}_KFE", r"-?0\.209", _turned_sign)
    rows = (("joint frame", f"{leg}_KFE", "moved"), ("pose at zero", f"{leg}_foot", "moved"))
    return Planted(text, rows, ((f"{leg}_KFE", "translation y", "sign swapped"),))


def swapped_product_sign(leg: str) -> Planted:
    text = _in_block(TEXT, f"link {leg}_hip", r"(?<=Iyz = )-?[\d.]+", _turned_sign)
    rows = (("inertia", f"{leg}_hip", "principal axes turned"),)
    return Planted(text, rows, ((f"{leg}_hip", "Iyz", "sign swapped"),))


def changed_mass(leg: str) -> Planted:
    text = _in_block(TEXT, f"link {leg}_thigh", r"mass = [\d.]+", "mass = 0.7")
    return Planted(text, (("inertia", f"{leg}_thigh", "mass 0.634 -> 0.7 kg"),
                          ("total", "mass", "(+")), ((f"{leg}_thigh", "mass", ""),))  # fmt: skip


def grams(leg: str) -> Planted:
    text = _in_block(TEXT, f"link {leg}_thigh", r"mass = [\d.]+", "mass = 634.0")
    remark = "1000 times: another unit?"
    return Planted(
        text, (("inertia", f"{leg}_thigh", "mass"),), ((f"{leg}_thigh", "mass", remark),)
    )


def moved_com(leg: str) -> Planted:
    text = _in_block(TEXT, f"link {leg}_thigh", r"CoM = \([^,]+,", "CoM = (0.01,")
    return Planted(text, (("inertia", f"{leg}_thigh", "CoM moved 10 mm"),),
                   ((f"{leg}_thigh", "CoM x", ""),))  # fmt: skip


def renamed_link(leg: str) -> Planted:
    text = _renamed(TEXT, f"{leg}_shank", f"{leg}_shin")
    return Planted(text, (("link", f"{leg}_shin", f"renamed, was '{leg}_shank'"),))


def renamed_joint(leg: str) -> Planted:
    text = _renamed(TEXT, f"{leg}_KFE", f"{leg}_knee")
    return Planted(text, (("joint", f"{leg}_knee", f"renamed, was '{leg}_KFE'"),))


def sliding_joint(leg: str) -> Planted:
    text = TEXT.replace(f"r_joint {leg}_KFE", f"p_joint {leg}_KFE")
    return Planted(text, (("joint", f"{leg}_KFE", "revolute -> prismatic"),))


def turned_frame(_: str) -> Planted:
    text = _in_block(TEXT, "RobotBase", r"rotation = \(PI/2.0, 0.0, PI/2.0\)",
                     "rotation = (90.0, 0.0, PI/2.0)")  # fmt: skip
    return Planted(text, (("frame", "camera", "moved 0 mm, turned"),),
                   (("trunk.camera", "rotation x", "180/PI times: degrees?"),))  # fmt: skip


def reparented(leg: str) -> Planted:
    other = next(name for name in _LEGS if name != leg)
    edge = f"{leg}_shank via {leg}_KFE"
    text = TEXT.replace(f"        {edge}\n", "")
    text = text.replace(
        f"{other}_shank via {other}_KFE", f"{other}_shank via {other}_KFE\n        {edge}"
    )
    told = f"attached to '{other}_thigh' instead of '{leg}_thigh'"
    return Planted(text, (("link", f"{leg}_shank", told),))


def fixed_base(_: str) -> Planted:
    return Planted(TEXT.replace("trunk floating", "trunk"), (("base", "", "floating -> fixed"),))


def removed_frame(leg: str) -> Planted:
    text = re.sub(rf"frames \{{\s*{leg}_foot \{{[^}}]*\}}\s*\}}", "", TEXT)
    return Planted(text, (("frame", f"{leg}_foot", "removed"),))


EDITS: tuple[Callable[[str], Planted], ...] = (
    moved_joint, swapped_joint_sign, swapped_product_sign, changed_mass, grams, moved_com,
    renamed_link, renamed_joint, sliding_joint, turned_frame, reparented, fixed_base, removed_frame,
)  # fmt: skip


def planted(edit: Callable[[str], Planted], seed: int) -> Planted:
    """Return an edit of one leg or another."""
    found = edit(Random(seed).choice(_LEGS))
    assert found.text != TEXT
    return found
