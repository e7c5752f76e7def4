"""Reads a document down to its numbered bodies, for commands that need the mechanics."""

from typing import TYPE_CHECKING

from kindsl.cli.documents.reading import CommandError, defect, require_syntax
from kindsl.cli.outcome import Failure

if TYPE_CHECKING:
    from kindsl.analysis.analysis import Analysis
    from kindsl.dynamics.bodies import Bodies

BINDING_HINT = "bind it with --param NAME=VALUE or in kindsl.toml"


def bodies_of_document(path: str, analysis: "Analysis") -> "Bodies":
    """Return the bodies of a document.

    Raises:
        CommandError: It does not describe a mechanism, or NumPy is missing.
    """
    from kindsl.mechanism.errors import ModelError, UnboundParameterError

    require_syntax(path, analysis)
    try:
        return analysis.mechanism().bodies
    except UnboundParameterError as error:
        raise defect(path, analysis, f"{error}; {BINDING_HINT}", error.at) from None
    except ModelError as error:
        raise defect(path, analysis, str(error), error.at) from None
    except ModuleNotFoundError as error:
        raise missing_module(path, error, "numpy") from None


def missing_module(path: str, error: ModuleNotFoundError, extra: str) -> CommandError:
    """Return the error for a library that is not installed."""
    message = f"{error.name} is not installed: pip install 'kindsl[{extra}]'"
    return CommandError([Failure(path, message)])
