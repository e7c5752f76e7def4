"""Robots of others: the published models, what `pip` brings, and folders that are given.

A file in another format is converted once; its document is kept in `build/robots`. Robots are split
in two by the folder that they come from, so that variants of one robot are never on both sides:
what is fitted on one half is measured on the other.
"""

import hashlib
import re
import signal
import sysconfig
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple
from zlib import crc32

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.robots.interchange.format import FormatError, ReadingChoices
from kindsl.robots.interchange.kindsl_writing import written_kindsl
from kindsl.robots.interchange.registry import format_of_suffix

ROOT = Path(__file__).resolve().parents[1]
KEPT = ROOT / "build" / "robots"
FOLDERS = (ROOT / "examples", ROOT.parent / "shared" / "corpus")
SUFFIXES = (".kindsl", ".urdf", ".sdf", ".xml", ".xacro")
# Where packages that `pip` installs keep robots: `example-robot-data` is one of the tests' own.
SHARED = "cmeel.prefix/share/example-robot-data/robots"
MOST_SECONDS, MOST_BYTES = 20, 400_000
PLACES = re.compile(r"urdf|xacro|xml|mjcf|robots?|models?|assets|description|data", re.IGNORECASE)


class Published(NamedTuple):
    """A robot of others.

    Attributes:
        name: Its file, behind its folder.
        family: What it shares with its variants.
        analysis: Of its document.
        in_place: Of the URDF that it was converted from, None where it is of another format.
    """

    name: str
    family: str
    analysis: Analysis
    in_place: Analysis | None = None

    @property
    def half(self) -> int:
        """The half it belongs to: 0 to fit on, 1 to measure on."""
        return crc32(self.family.encode()) % 2


def published(
    folders: Sequence[Path] = (), half: int | None = None, urdf_only: bool = False
) -> list[Published]:
    """Return the robots that can be read, each once, of one half or of both.

    Args:
        folders: Where to look besides.
        half: Which half.
        urdf_only: Whether to take the URDFs alone, judged where they stand as well.
    """
    found: dict[str, Published] = {}
    installed = Path(sysconfig.get_path("purelib")) / SHARED
    for folder in (*FOLDERS, installed, *folders):
        for path in sorted(folder.rglob("*")):
            suffixes = (".urdf",) if urdf_only else SUFFIXES
            if path.suffix not in suffixes or not path.is_file():
                continue
            family = _family(path.relative_to(folder))
            if half is not None and crc32(family.encode()) % 2 != half:
                continue
            text = _document(path)
            if text and text not in found:
                analysis = analyse(text)
                if len(analysis.model.links) > 1 and not analysis.model.broken_islands:
                    there = analyse(path.read_text("utf-8", "replace")) if urdf_only else None
                    found[text] = Published(f"{family}/{path.name}", family, analysis, there)
    return list(found.values())


def _family(path: Path) -> str:
    """Return the folder of a robot, or its file's first word where it is in none of its own."""
    folders = [part for part in path.parts[:-1] if not PLACES.fullmatch(part)]
    words = folders[-1:] or [path.stem]
    return re.split(r"[_\d.]", words[0].lower())[0] or words[0]


def _document(path: Path) -> str:
    content = path.read_bytes()
    if path.suffix == ".kindsl":
        return content.decode("utf-8", "replace")
    if len(content) > MOST_BYTES:
        return ""
    kept = KEPT / f"{hashlib.sha256(str(path).encode() + content).hexdigest()[:24]}.kindsl"
    if not kept.exists():
        KEPT.mkdir(parents=True, exist_ok=True)
        kept.write_text(_converted(path), "utf-8")
    return kept.read_text("utf-8")


def _converted(path: Path) -> str:
    """Return a file of another format as a document, empty where it is no robot."""
    format_ = format_of_suffix(path.suffix)
    if format_ is None or format_.read is None:
        return ""
    try:
        with _limit(MOST_SECONDS):
            return written_kindsl(format_.read(path, ReadingChoices())).text
    except (FormatError, TimeoutError, OSError, ValueError, RecursionError):
        return ""


@contextmanager
def _limit(seconds: int) -> Iterator[None]:
    def stop(*_: object) -> None:
        raise TimeoutError

    # Of the processor: a busy machine must not lose robots, since what is not read is kept as such.
    signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
