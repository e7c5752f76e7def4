"""Loads, after the client has its answer to `initialize`, what later answers need.

One job a module, so that a first question waits for one import at most.
"""

import logging
import pkgutil
from collections.abc import Iterator
from functools import partial
from importlib import import_module

from kindsl.frontends.lsp.session.worker import Urgency, Worker

logger = logging.getLogger(__name__)

FIRST = (
    "kindsl.judgement.analysis.analysis",
    "kindsl.judgement.config.editor_settings",
    "kindsl.judgement.config.discovery",
)
LATER = (
    "kindsl.language.formatting",
    "kindsl.judgement.config.toml_edits",
    "numpy",
    "kindsl.robots.mechanism.build",
)


def warm_up(worker: Worker) -> None:
    """Queue the imports: first what any answer needs, the rest when nobody waits."""
    for module in FIRST:
        worker.submit(partial(_load, module))
    worker.submit(_load_rules, Urgency.DIAGNOSTICS)
    for module in (*_features(), *LATER):
        worker.submit(partial(_load, module), Urgency.BACKGROUND)


def _load(module: str) -> None:
    try:
        import_module(module)
    except ImportError as error:
        logger.info("%s is not there: %s", module, error)


def _load_rules() -> None:
    from kindsl.judgement.rules.registry import all_rules

    all_rules()


def _features() -> Iterator[str]:
    package = import_module("kindsl.frontends.features")
    for found in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
        yield found.name
