"""One file adds one thing: each test writes one to a folder of its own and uses it."""

import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType

import pytest
from lsprotocol import types
from tests.cli.samples import GOOD

from kindsl.frontends import cli
from kindsl.frontends.cli.commands import command_module, command_summaries, runs_long
from kindsl.frontends.cli.main import main
from kindsl.frontends.lsp import handlers
from kindsl.frontends.lsp.server import KindslLanguageServer
from kindsl.frontends.mcp import tools
from kindsl.frontends.mcp.folder import Folder
from kindsl.frontends.mcp.tool import all_tools, answer
from kindsl.language.text.modules import module_names
from kindsl.mechanics.dynamics.generation import emitters
from kindsl.products.codegen import languages
from kindsl.robots import interchange
from kindsl.robots.interchange.registry import all_formats

Add = Callable[[ModuleType, str, str], None]


@pytest.fixture
def add(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Add]:
    """Return what writes a file as if it were in a package; it is forgotten afterwards."""
    before = set(sys.modules)
    all_formats.cache_clear()

    def write(package: ModuleType, file: str, text: str) -> None:
        folder = tmp_path / package.__name__
        path = folder / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        monkeypatch.setattr(package, "__path__", [*package.__path__, str(folder)])

    yield write
    all_formats.cache_clear()
    for name in set(sys.modules) - before:
        if (getattr(sys.modules[name], "__file__", None) or "").startswith(str(tmp_path)):
            del sys.modules[name]


COMMAND = '''\
"""Greets a robot."""

SUMMARY = "greet a robot: 'hello'"


def add_arguments(parser):
    parser.add_argument("name")


def run(args):
    print(f"hello {args.name}")
    return 3
'''


def test_a_command(add: Add, capfd: pytest.CaptureFixture[str]) -> None:
    add(cli, "say_hello.py", COMMAND)
    assert main(["--help"]) == 0
    assert "\n  say-hello        greet a robot: 'hello'\n" in capfd.readouterr().out
    assert main(["say-hello", "arm"]) == 3
    assert capfd.readouterr().out == "hello arm\n"
    assert main(["say-helo"]) == 2
    assert "did you mean 'say-hello'?" in capfd.readouterr().err
    assert not runs_long("say-hello")


def test_a_command_that_runs_long_says_so(add: Add) -> None:
    add(cli, "watch.py", '"""Watches."""\n\nSUMMARY = "watch a robot"\nRUNS_LONG = True\n')
    assert runs_long("watch")
    assert [name for name in command_summaries() if runs_long(name)] == [
        "language-server", "mcp", "preview", "watch",
    ]  # fmt: skip


def test_what_is_read_of_commands_is_what_they_say() -> None:
    found = command_summaries()
    assert len(found) > 10
    for name, summary in found.items():
        module = command_module(name)
        assert module is not None
        assert (module.SUMMARY, getattr(module, "RUNS_LONG", False)) == (summary, runs_long(name))
    others = set(module_names(cli)) - {name.replace("-", "_") for name in found}
    assert others > {"main", "console"}
    assert not any(map(command_module, others))


FORMAT = '''\
"""Knows names of robots.

Must not know what they are made of.
"""

from kindsl.robots.interchange.format import Format, WrittenRobot


def _write(name, skeleton, choices):
    return WrittenRobot(f"{name}: {', '.join(skeleton.joint_names)}", ("poses dropped",))


FORMAT = Format("roster", "list of names", (".roster",), write=_write)
'''


def test_a_format(add: Add, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    add(interchange, "roster/__init__.py", FORMAT)
    (tmp_path / "arm.kindsl").write_text(GOOD)
    written = tmp_path / "arm.roster"
    assert main(["convert", str(tmp_path / "arm.kindsl"), str(written)]) == 0
    assert "arm.kindsl:\n  note: poses dropped\n" in capfd.readouterr().err
    assert written.read_text() == "arm: shoulder, elbow"
    assert main(["convert", str(written), str(tmp_path / "arm.urdf")]) == 2
    assert "list of names cannot be read" in capfd.readouterr().err


HANDLER = '''\
"""The length of a document, by a command."""

from kindsl.frontends.lsp.handlers.table import Handlers

handlers = Handlers()


@handlers.command("kindsl.length")
def length(session, uri):
    """Return the number of characters."""
    return session.documents.get(uri).lines.length
'''


async def test_a_handler(add: Add) -> None:
    add(handlers, "counting.py", HANDLER)
    server = KindslLanguageServer()
    robot = types.TextDocumentItem("untitled:r", "kinematics-dsl", 1, "Robot r {}")
    server.protocol.documents.open(robot)
    told = server.protocol.fm.commands["kindsl.length"](robot.uri)
    assert told == len(robot.text)


EMITTER = '''\
"""Writes a value in prefix notation."""

from kindsl.mechanics.dynamics.generation.terms import Term


def prefix_notation(graph, value):
    """Return the text of a value."""
    if not isinstance(value, Term):
        return f"{value:g}"
    operation, *operands = graph.nodes[value.index]
    if operation == "input":
        return f"x{value.index}"
    values = [Term(graph, o) if isinstance(o, int) else o for o in operands]
    words = (prefix_notation(graph, value) for value in values)
    return f"({' '.join([operation, *words])})"
'''

LANGUAGE = '''\
"""Lists in prefix notation."""

from kindsl.products.codegen.language import COMMON_OPTIONS, Language
from kindsl.mechanics.dynamics.generation.emitters.prefix import prefix_notation


def _files(library, reference):
    lines = [
        f"(define {function.name}.{result.name} {prefix_notation(library.robot.graph, entry)})\\n"
        for function in library.all_functions
        for result in function.results
        for entry in result.entries
    ]
    return {f"{library.prefix}.scm": "".join(lines)}


LANGUAGE = Language(_files, COMMON_OPTIONS | {"--real"})
'''


def test_a_language_and_its_emitter(
    add: Add, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    add(emitters, "prefix.py", EMITTER)
    add(languages, "scheme.py", LANGUAGE)
    document, folder = tmp_path / "arm.kindsl", tmp_path / "out"
    document.write_text(GOOD)
    asked = ["generate", str(document), "--language", "scheme", "-o", str(folder)]
    assert main([*asked, "--single-header"]) == 2
    message = "--single-header has no effect with --language scheme, only with c\n"
    assert message in capfd.readouterr().err
    assert main([*asked, "--quantities", "gravity_torque", "--real", "float"]) == 0
    text = (folder / "arm.scm").read_text()
    assert text.startswith("(define gravity_torque.")
    assert main(["generate", str(document), "--check", str(folder)]) == 0
    manifest = folder / "kindsl-generated.json"
    text = manifest.read_text()
    manifest.write_text(text.replace('"scheme"', '"lisp"'))
    assert main(["generate", str(document), "--check", str(folder)]) == 1
    assert "is not a manifest of generated code" in capfd.readouterr().err
    manifest.write_text(text)
    document.write_text(GOOD.replace("mass = ", "mass = 2"))
    assert main(["generate", str(document), "--check", str(folder)]) == 1


TOOL = '''\
"""Greet a robot."""

from kindsl.frontends.mcp.tool import Arguments, text


def run(arguments: Arguments, folder):
    return [text(f"hello from {folder.root.name}")]
'''


def test_a_tool_for_assistants(add: Add, tmp_path: Path) -> None:
    add(tools, "greet.py", TOOL)
    tool = all_tools()["greet"]
    (content,) = answer(tool, {}, Folder(tmp_path))
    assert (tool.description, content.type) == ("Greet a robot.", "text")
