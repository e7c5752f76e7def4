"""The last lines of a verbose run: whether each generator reads each document."""

from collections.abc import Iterator, Sequence

from kindsl.frontends.cli.outcome import LintedFile
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.verdicts import verdicts
from kindsl.judgement.config.robots import SUFFIX
from kindsl.language.text.printable import printable


def verdict_lines(files: Sequence[LintedFile]) -> str:
    """Return a line for each generator, with the document's name where there are several."""
    documents = [file for file in files if _is_robot(file)]
    return "".join(
        f"{printable(f'{file.path}: ' if len(documents) > 1 else '')}{told}\n"
        for file in documents
        for told in _told(file)
    )


def _told(file: LintedFile) -> Iterator[str]:
    return map(str, verdicts(analyse(file.text)))


def _is_robot(file: LintedFile) -> bool:
    return file.path.endswith(SUFFIX) or "." not in file.path.rpartition("/")[2]
