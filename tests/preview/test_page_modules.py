"""The page's modules import downwards only, types included."""

import posixpath
import re

from tests.preview.robots import ROOT

PAGE = ROOT / "server" / "kindsl" / "frontends" / "preview" / "page"
# The lowest first; a folder imports from itself and from those before it.
FOLDERS = ("base", "picture", "panel", "editing", "")
# What the server says is written from its own classes; it imports nothing.
MESSAGES = "messages.js"
IMPORT = re.compile(r'(?:^import|@import|^import type) [^;]*? from "(\.[^"]*)"', re.MULTILINE)


def imports():
    """Return the modules that each module imports from, by their names."""
    found = {}
    for file in sorted(PAGE.rglob("*.js")) + sorted(PAGE.rglob("*.d.ts")):
        name = file.relative_to(PAGE).as_posix().replace(".d.ts", ".js")
        folder = posixpath.dirname(name)
        addresses = IMPORT.findall(file.read_text("utf-8"))
        found[name] = {posixpath.normpath(posixpath.join(folder, at)) for at in addresses}
    return found


def test_imports_point_downwards():
    known = imports()
    for name, others in known.items():
        for other in others - {MESSAGES}:
            assert other in known, f"{name} imports {other}, which is not there"
            below = FOLDERS.index(posixpath.dirname(other))
            assert below <= FOLDERS.index(posixpath.dirname(name)), f"{name} imports {other}"
    assert not known[MESSAGES]
    assert sum(map(len, known.values())) > 150


def test_no_module_imports_itself_over_others():
    known = {name: set(others) for name, others in imports().items()}
    while free := {name for name, others in known.items() if not others}:
        known = {name: others - free for name, others in known.items() if name not in free}
    assert not known
