"""Looks for inputs that break a target, guided by coverage.

    python -m tests.fuzz.run --target document --runs 1000000

Needs `pip install 'kindsl[fuzz]'`. Begins with the fixed corpus; what is new goes to a folder of
its own. An input that fails is written to `artifacts/fuzz/`: make it smaller, put it into the
target's corpus, and repair.
"""

import argparse
import gc
import importlib
import sys
import tempfile
from pathlib import Path

import atheris
from tests.fuzz.inputs import FOLDER, TARGETS, words

FOUND = FOLDER.parents[1] / "artifacts" / "fuzz"
_SERVER = FOLDER.parents[1] / "server"
# Of quick targets, what their inputs are meant to reach: to be watched takes most time.
_WATCHED = {
    "document": ("kindsl.language.syntax.", "kindsl.judgement.rules.checks."),
    "page": ("kindsl.frontends.preview.", "kindsl.frontends.features.manipulation."),
}
# Not watched: how the parser looks for a repair says little of an input, and takes most time.
_SEARCH = (
    "kindsl.language.syntax.automaton",
    "kindsl.language.syntax.recovery.prices",
    "kindsl.language.syntax.recovery.repair",
)
_LONGEST, _MOST_BYTES = {"document": 64}, 4096
_SECONDS_AN_INPUT = 20


def main() -> None:
    """Run until as many inputs are tried, or one fails."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--target", required=True, choices=TARGETS)
    parser.add_argument("--runs", type=int, default=10_000, help="how many inputs are tried")
    options = parser.parse_args()
    with atheris.instrument_imports(include=["kindsl"], exclude=_not_watched(options.target)):
        target = importlib.import_module(f"tests.fuzz.targets.{options.target}")
    FOUND.mkdir(parents=True, exist_ok=True)
    new = tempfile.mkdtemp(prefix=f"fuzz-{options.target}-")
    listed = Path(new).with_suffix(".dict")
    lines = (f'"{_quoted(word)}"\n' for word in words(options.target))
    listed.write_text("".join(lines), encoding="ascii")
    arguments = [
        *(sys.argv[0], new, str(FOLDER / "corpus" / options.target)),
        *(
            f"-dict={listed}",
            f"-runs={options.runs}",
            f"-max_len={_LONGEST.get(options.target, _MOST_BYTES)}",
        ),
        *(f"-timeout={_SECONDS_AN_INPUT}", f"-artifact_prefix={FOUND}/{options.target}-"),
        *("-print_final_stats=1", "-rss_limit_mb=4096"),
    ]
    gc.freeze()  # what is loaded stays
    atheris.Setup(arguments, target.one_input)
    atheris.Fuzz()


def _not_watched(target: str) -> list[str]:
    """Return the modules from which no coverage is taken."""
    files = (path.relative_to(_SERVER).with_suffix("") for path in _SERVER.rglob("*.py"))
    names = (".".join(file.parts) for file in files)
    watched = _WATCHED.get(target, ("kindsl",))
    return [*_SEARCH, *(name for name in names if not name.startswith(watched))]


def _quoted(word: bytes) -> str:
    return "".join(f"\\x{byte:02x}" for byte in word)


if __name__ == "__main__":
    main()
