"""Slips as they were published, planted in whole robots: the answer names link and number."""

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from mcp.types import TextContent

from kindsl.frontends.mcp.folder import Folder
from kindsl.frontends.mcp.tool import all_tools, answer

EXAMPLES = Path(__file__).parents[2] / "examples"
MOMENTS = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")
Change = Callable[[dict[str, str]], dict[str, str]]


def row_major(block: dict[str, str]) -> dict[str, str]:
    """The order of a URDF: xx, xy, xz, yy, yz, zz, typed into the language's."""
    order = ("Ix", "Ixy", "Ixz", "Iy", "Iyz", "Iz")
    return {name: block[of] for name, of in zip(MOMENTS, order, strict=True)}


def negative_moments(block: dict[str, str]) -> dict[str, str]:
    return {name: f"-{block[name]}" for name in MOMENTS[:3]}


def mass_in_grams(block: dict[str, str]) -> dict[str, str]:
    return {"mass": f"{1000 * float(block['mass']):.1f}"}


SLIPS: list[tuple[str, str, Change]] = [
    (robot, link, change)
    for robot, links in {
        "quadruped": ("LF_thigh", "RH_shank", "LH_hip"),
        "industrial_arm": ("upper_arm", "forearm", "wrist_3_link"),
    }.items()
    for link in links
    for change in (row_major, negative_moments, mass_in_grams)
]


def planted(text: str, link: str, change: Change) -> str:
    start = text.index(f"link {link} ")
    end = text.index("children", start)
    block = text[start:end]
    values = dict(re.findall(r"(\w+) = ([-\d.]+)\n", block))
    for name, value in change(values).items():
        block = re.sub(rf"\b{name} = .*", f"{name} = {value}", block)
    return text[:start] + block + text[end:]


@pytest.mark.parametrize(("robot", "link", "change"), SLIPS)
def test_a_body(tmp_path: Path, robot: str, link: str, change: Change) -> None:
    text = planted((EXAMPLES / f"{robot}.kindsl").read_text(), link, change)
    first = checked(tmp_path, text)
    lines = text.splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith(f"link {link} "))
    assert link in first["message"] or start < first["start"]["line"] <= start + 14, first


@pytest.mark.parametrize("link", ["RF_shank", "LH_shank"])
def test_a_parent(tmp_path: Path, link: str) -> None:
    text = (EXAMPLES / "quadruped.kindsl").read_text()
    knee = link.replace("shank", "KFE")
    line = f"        {link} via {knee}\n"
    text = text.replace(line, "").replace(
        "        LF_shank via LF_KFE\n", f"        LF_shank via LF_KFE\n{line}"
    )
    assert link in checked(tmp_path, text)["message"]


def checked(folder: Path, text: str) -> dict[str, Any]:
    (content,) = answer(all_tools()["check"], {"text": text}, Folder(folder))
    assert isinstance(content, TextContent)
    found = json.loads(content.text)["findings"]
    assert found, "nothing found"
    return found[0]
