"""A drag goes down through the house: what a page asks for is decided below, then shown above.

The request is followed through the calls that pass it on, or what was made of it, each function
once. A climb is a step of this walk to a file of a higher layer.
"""

import asyncio
import json
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from types import FrameType
from typing import Any

from tests.preview.robots import ARM

import kindsl
from kindsl.frontends.preview.channel import Tab
from kindsl.frontends.preview.document_preview import DocumentPreview
from kindsl.frontends.preview.dragging import Dragging
from kindsl.frontends.preview.requests import request_of
from kindsl.frontends.preview.steps import Writing
from kindsl.judgement.analysis.analysis import analyse

HOUSE = Path(kindsl.__file__).parent
# Fewer than ten: each stage comes back once, and drawing asks for shapes in between.
MOST_CLIMBS = 9
GRASP = {"type": "grasp", "kind": "joint", "name": "lift"}
DRAG = {"type": "drag", "kind": "joint", "name": "lift", "component": "x", "step": None}
STORY = (
    GRASP, {**DRAG, "value": 0.55, "phase": "move"}, {**DRAG, "value": 0.57, "phase": "drop"},
)  # fmt: skip


def houses() -> dict[str, int]:
    """Return the height of each house, as the import contract has it."""
    text = (HOUSE.parents[1] / "pyproject.toml").read_text(encoding="utf-8")
    contracts = tomllib.loads(text)["tool"]["importlinter"]["contracts"]
    (names,) = (contract["layers"] for contract in contracts if contract["id"] == "houses")
    return {name: -depth for depth, name in enumerate(names)}


class Walk:
    """The functions that are given what came of a request, in the order in which they begin."""

    def __init__(self) -> None:
        self.functions: dict[tuple[str, str], None] = {}
        self._passed: dict[int, Any] = {}
        self._inside: dict[int, FrameType] = {}

    def follow(self, thing: Any) -> None:
        """Follow what came of the request; the one empty tuple came of all that is empty."""
        if not isinstance(thing, bool | int | None) and thing not in ("", ()):
            self._passed[id(thing)] = thing

    def see(self, frame: FrameType, event: str, result: Any) -> None:
        """Be the profile function of a thread."""
        code = frame.f_code
        if not code.co_filename.startswith(str(HOUSE)) or code.co_name.startswith("<"):
            return
        if event == "call":
            names = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
            if any(self._holds(frame.f_locals.get(name)) for name in names if name != "self"):
                self._inside[id(frame)] = frame
                self.functions[code.co_filename, code.co_qualname] = None
        elif event == "return" and id(frame) in self._inside and not asyncio.iscoroutine(result):
            self.follow(result)

    def _holds(self, thing: Any, depth: int = 2) -> bool:
        if id(thing) in self._passed:
            return True
        items = thing.values() if isinstance(thing, dict) else thing
        is_small = isinstance(thing, tuple | list | dict) and len(thing) < 30
        return bool(depth and is_small and any(self._holds(item, depth - 1) for item in items))

    def climbs(self) -> Iterator[tuple[str, str]]:
        heights = houses()
        files = [Path(file).relative_to(HOUSE) for file, _ in self.functions]
        for before, after in pairwise(files):
            if heights[after.parts[0]] > heights[before.parts[0]]:
                yield before.as_posix(), after.as_posix()


async def walk_of(*requests: dict[str, Any]) -> Walk:
    preview, walk = DocumentPreview("arm"), Walk()

    async def write(writing: Writing) -> str:
        assert preview.analysis is not None and preview.analysis.text == writing.text
        preview.show(preview.analysis.edited(writing.edits), ())
        return ""

    async def nowhere(_: object) -> None:
        """Take what a page is told."""

    dragging = Dragging(preview, write)
    preview.show(analyse(ARM), ())
    preview.channel.join(Tab(nowhere))
    former = sys.getprofile()
    for data in requests:
        # As a page's comes: its words are no objects that the program shares with its own.
        request = request_of(json.loads(json.dumps({**data, "revision": preview.revision})))
        assert request is not None
        for thing in (request, *request):
            walk.follow(thing)
        sys.setprofile(walk.see)
        try:
            await dragging.receive(request)  # type: ignore[arg-type]
        finally:
            sys.setprofile(former)
    return walk


def tell_walk() -> None:
    """Print the files of the walk and its climbs."""
    walk = asyncio.run(walk_of(*STORY))
    files = {Path(file).relative_to(HOUSE).as_posix() for file, _ in walk.functions}
    print(json.dumps([sorted(files), list(walk.climbs())]))


def test_a_drag_goes_down():
    """In a process of its own: what others have computed before is asked for no more."""
    told = subprocess.run(
        [sys.executable, "-c", f"from {__name__} import tell_walk; tell_walk()"],
        cwd=Path(__file__).parents[2], capture_output=True, text=True, check=True,
    )  # fmt: skip
    files, climbs = json.loads(told.stdout)
    assert {
        "frontends/preview/outcomes.py", "frontends/features/manipulation/set_component.py",
        "judgement/analysis/analysis.py",
        "language/syntax/document.py", "language/text/edits.py",
    } <= set(files)  # fmt: skip
    assert len(climbs) <= MOST_CLIMBS, climbs


async def test_a_climb_is_seen():
    walk = Walk()
    edits, analysis = "language/text/edits.py", "judgement/analysis/analysis.py"
    files = ("frontends/preview/dragging.py", edits, analysis, edits)
    walk.functions = {(str(HOUSE / file), str(i)): None for i, file in enumerate(files)}
    assert list(walk.climbs()) == [(edits, analysis)]
