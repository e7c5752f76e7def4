"""Baselines: files that say which findings of which documents are known."""

import json
import os
from collections import Counter
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import NoReturn

from kindsl.judgement.config.configuration import Configuration
from kindsl.judgement.config.configuration_reading import error_at
from kindsl.judgement.config.schema import Mistake
from kindsl.language.text.regular import content_of
from kindsl.language.text.saves import Stamp, stamp

_DOCUMENTS = "documents"

Baseline = Mapping[str, Mapping[str, int]]
"""How often each finding is known, by the document's path from the baseline's folder."""


def known_findings(configuration: Configuration, document: str) -> Mapping[str, int]:
    """Return how often each finding of a document is known.

    Raises:
        ConfigurationError: The configuration names a file that is not a baseline.
    """
    return read_baseline(configuration).get(path_in(baseline_path(configuration), document), {})


def read_baseline(configuration: Configuration) -> Baseline:
    """Return the baseline that a configuration names, empty if it names none.

    Raises:
        ConfigurationError: It names a file that is not a baseline.
    """
    path = baseline_path(configuration)
    if not path:
        return {}
    try:
        return _read(path, stamp(path))
    except OSError as error:
        _refuse(configuration, f"cannot be read: {error.strerror}")
    except (ValueError, RecursionError):
        _refuse(configuration, "was not written by --write-baseline")


def baseline_path(configuration: Configuration) -> str:
    """Return the path of the baseline that a configuration names, empty if it names none."""
    folder = os.path.dirname(configuration.path)
    return os.path.join(folder, configuration.baseline) if configuration.baseline else ""


def path_in(baseline: str, document: str) -> str:
    """Return what a baseline calls a document: its path from the baseline's folder."""
    folder = os.path.dirname(os.path.abspath(baseline))
    return os.path.relpath(document, folder).replace(os.sep, "/")


def baseline_text(known: Mapping[str, Iterable[str]]) -> str:
    """Return the text of a baseline, by document what identifies each of its findings."""
    documents = {path: found for path in sorted(known) if (found := list(known[path]))}
    return json.dumps({_DOCUMENTS: documents}, indent=1, ensure_ascii=False) + "\n"


@lru_cache(maxsize=4)
def _read(path: str, _: Stamp | None) -> Baseline:
    return _counted(json.loads(content_of(path).decode("utf-8")))


def _counted(content: object) -> Baseline:
    documents = content.get(_DOCUMENTS) if isinstance(content, dict) else None
    if not isinstance(documents, dict) or not all(map(_is_texts, documents.values())):
        raise ValueError
    return {path: Counter(known) for path, known in documents.items()}


def _is_texts(known: object) -> bool:
    return isinstance(known, list) and all(isinstance(one, str) for one in known)


def _refuse(configuration: Configuration, what: str) -> NoReturn:
    sentence = f"baseline '{configuration.baseline}' {what}"
    raise error_at(configuration, [Mistake(("baseline",), sentence)])
