"""Language tools and mechanics for the Kinematics-DSL.

`load` and `parse` read documents; everything else is asked of what they return. Importing this
package imports nothing else: NumPy comes with the first mechanism, the parser with the first text.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import os

    from kindsl.judgement.analysis.analysis import Analysis as Document
    from kindsl.judgement.analysis.settings import Settings
    from kindsl.mechanics.dynamics.evaluation.compiling import CompileError
    from kindsl.mechanics.spatial.exponential import pose_error
    from kindsl.robots.cad.properties import MassProperties
    from kindsl.robots.cad.report import ReportError
    from kindsl.robots.mechanism.build import Mechanism
    from kindsl.robots.mechanism.errors import (
        ModelError,
        ParameterValueError,
        UnboundParameterError,
    )

__all__ = [
    "CompileError",
    "Document",
    "MassProperties",
    "Mechanism",
    "ModelError",
    "ParameterValueError",
    "ReportError",
    "UnboundParameterError",
    "__version__",
    "live",
    "load",
    "mass_properties",
    "parse",
    "pose_error",
]

__version__ = "0.1.0"

_PLACES = {
    "CompileError": ("kindsl.mechanics.dynamics.evaluation.compiling", "CompileError"),
    "Document": ("kindsl.judgement.analysis.analysis", "Analysis"),
    "MassProperties": ("kindsl.robots.cad.properties", "MassProperties"),
    "Mechanism": ("kindsl.robots.mechanism.build", "Mechanism"),
    "ModelError": ("kindsl.robots.mechanism.errors", "ModelError"),
    "ParameterValueError": ("kindsl.robots.mechanism.errors", "ParameterValueError"),
    "ReportError": ("kindsl.robots.cad.report", "ReportError"),
    "UnboundParameterError": ("kindsl.robots.mechanism.errors", "UnboundParameterError"),
    "pose_error": ("kindsl.mechanics.spatial.exponential", "pose_error"),
}


def load(path: "str | os.PathLike[str]", settings: "Settings | None" = None) -> "Document":
    """Return the document in a file; bad text gives findings, never an error.

    Args:
        path: The file. Bytes that are no UTF-8 become findings.
        settings: Rules, targets and bindings; None for what the nearest kindsl.toml says.

    Raises:
        OSError: The file cannot be read.
        kindsl.judgement.config.configuration.ConfigurationError: The kindsl.toml is wrong.
    """
    from kindsl.language.text.encodings import decoded

    with open(path, "rb") as file:
        text = decoded(file.read())
    if settings is None:
        settings = _settings_for(path)
    return parse(text, settings)


def mass_properties(text: str) -> "MassProperties":
    """Return the mass properties that a report of a CAD program has.

    Args:
        text: The program's report of one body.

    Raises:
        ReportError: There is no report in the text, something in it is missing, or its numbers
            contradict each other.
    """
    from kindsl.robots.cad.taking_over import mass_properties

    return mass_properties(text)


def parse(text: str, settings: "Settings | None" = None) -> "Document":
    """Return the document of a text; never raises, whatever the text.

    Args:
        settings: Rules, targets and bindings; None for the default ones.
    """
    from kindsl.judgement.analysis.analysis import analyse
    from kindsl.language.text.display import let_draw

    let_draw(_notebook_html)
    return analyse(text) if settings is None else analyse(text, settings)


def live(document: "Document") -> object:
    """Return a document's preview for a notebook, about a megabyte; needs the extra `preview`.

    Raises:
        ModuleNotFoundError: meshcat is not installed.
    """
    from importlib import import_module

    page: object = import_module("kindsl.frontends.preview.notebook").LivePage(document)
    return page


def _notebook_html(thing: object) -> str | None:
    """Return what a notebook shows of a thing of ours, None without what that needs."""
    from importlib import import_module

    try:
        drawing = import_module("kindsl.frontends.preview.notebook")
    except ModuleNotFoundError:
        return None
    html: str | None = drawing.notebook_html(thing)
    return html


def _settings_for(path: "str | os.PathLike[str]") -> "Settings":
    import os

    from kindsl.judgement.analysis.settings import Settings
    from kindsl.judgement.config.discovery import Configurations

    document = os.fspath(path)
    configuration = Configurations().above(document)
    return configuration.settings_for(document) if configuration else Settings()


def __dir__() -> list[str]:
    return __all__


def __getattr__(name: str) -> Any:
    if name in _PLACES:
        from importlib import import_module

        module, attribute = _PLACES[name]
        return getattr(import_module(module), attribute)
    raise AttributeError(f"module 'kindsl' has no attribute '{name}'")
