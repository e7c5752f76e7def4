"""Language tools and mechanics for the Kinematics-DSL.

`load` and `parse` read documents; everything else is asked of what they return. Importing this
package imports nothing else: NumPy comes with the first mechanism, the parser with the first text.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import os

    from kindsl.analysis.analysis import Analysis as Document
    from kindsl.analysis.settings import Settings
    from kindsl.cad.properties import MassProperties
    from kindsl.cad.report import ReportError
    from kindsl.dynamics.evaluation.compiler import CompileError
    from kindsl.mechanism.build import Mechanism
    from kindsl.mechanism.errors import ModelError, ParameterValueError, UnboundParameterError

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
]

__version__ = "0.1.0"

_PLACES = {
    "CompileError": ("kindsl.dynamics.evaluation.compiler", "CompileError"),
    "Document": ("kindsl.analysis.analysis", "Analysis"),
    "MassProperties": ("kindsl.cad.properties", "MassProperties"),
    "Mechanism": ("kindsl.mechanism.build", "Mechanism"),
    "ModelError": ("kindsl.mechanism.errors", "ModelError"),
    "ParameterValueError": ("kindsl.mechanism.errors", "ParameterValueError"),
    "ReportError": ("kindsl.cad.report", "ReportError"),
    "UnboundParameterError": ("kindsl.mechanism.errors", "UnboundParameterError"),
}


def load(path: "str | os.PathLike[str]", settings: "Settings | None" = None) -> "Document":
    """Return the document in a file; bad text gives findings, never an error.

    Args:
        path: The file. Bytes that are no UTF-8 become findings.
        settings: Rules, targets and bindings; None for what the nearest kindsl.toml says.

    Raises:
        OSError: The file cannot be read.
        kindsl.config.configuration.ConfigurationError: The kindsl.toml is wrong.
    """
    with open(path, "rb") as file:
        text = file.read().decode("utf-8", "surrogateescape")
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
    from kindsl.cad.taking_over import mass_properties

    return mass_properties(text)


def parse(text: str, settings: "Settings | None" = None) -> "Document":
    """Return the document of a text; never raises, whatever the text.

    Args:
        text: The source.
        settings: Rules, targets and bindings; None for the default ones.
    """
    from kindsl.analysis.analysis import analyse
    from kindsl.text.display import let_draw

    let_draw(_notebook_html)
    return analyse(text) if settings is None else analyse(text, settings)


def live(document: "Document") -> object:
    """Return a document's preview for a notebook, about a megabyte; needs the extra `preview`.

    Raises:
        ModuleNotFoundError: meshcat is not installed.
    """
    from importlib import import_module

    page: object = import_module("kindsl.preview.notebook").LivePage(document)
    return page


def _notebook_html(thing: object) -> str | None:
    """Return what a notebook shows of a thing of ours, None without what that needs."""
    from importlib import import_module

    try:
        drawing = import_module("kindsl.preview.notebook")
    except ModuleNotFoundError:
        return None
    html: str | None = drawing.notebook_html(thing)
    return html


def _settings_for(path: "str | os.PathLike[str]") -> "Settings":
    import os

    from kindsl.analysis.settings import Settings
    from kindsl.config.discovery import Configurations

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
