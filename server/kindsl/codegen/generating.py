"""From a document and options to the text of all files."""

from collections.abc import Mapping
from typing import NamedTuple

from kindsl import __version__
from kindsl.analysis.analysis import Analysis
from kindsl.codegen.c_test_program import parameter_values
from kindsl.codegen.language import language_named
from kindsl.codegen.library import (
    GenerationError,
    Library,
    Options,
    Stamp,
    library_of,
)
from kindsl.codegen.manifest import NAME, digest, manifest_text
from kindsl.codegen.names_in_code import command_line, file_name
from kindsl.codegen.reference import Reference, sample
from kindsl.codegen.resistance import refuse_unresisted
from kindsl.codegen.wanted import wanted_pairs
from kindsl.mechanism.symbolic import symbolic_robot
from kindsl.text.nearest import hint, nearest_name


class Source(NamedTuple):
    """A document to generate code for.

    Attributes:
        name: Its file's name.
        analysis: The document.
        bindings: Parameters bound on the command line.
        transforms: The text of a transforms document, None without one.
        places: The document and the options that name files and folders, as typed in its folder.
    """

    name: str
    analysis: Analysis
    bindings: Mapping[str, float]
    transforms: str | None = None
    places: tuple[str, ...] = ()


def generate(
    source: Source, options: Options, stamp: Stamp | None = None
) -> tuple[Library, dict[str, str]]:
    """Return a library and the text of its files by their names, the manifest last.

    Args:
        source: The document.
        options: What to write.
        stamp: What the files tell about their origin; None for the truth.

    Raises:
        GenerationError: A quantity or a name cannot be generated.
        kindsl.mechanism.errors.ModelError: The document describes no mechanism.
    """
    model, values = source.analysis.model, source.analysis.context.values
    inputs = _inputs(source.analysis, options.parameters)
    robot = symbolic_robot(model, values, inputs)
    stamp = stamp or Stamp(
        f"kindsl {__version__}",
        file_name(source.name),
        digest(source.analysis.text.encode("utf-8", "surrogateescape")),
        _typed(options, source),
    )
    defaults = {name: values.get(name) for name in inputs}
    name = str(model.name or "robot")
    parameters = parameter_values(defaults.items())
    mechanics = source.analysis.mechanism(parameters)
    values_of_arguments = sample(mechanics.bodies)
    refuse_unresisted(options.quantities, mechanics.bodies, values_of_arguments["q"])
    try:
        wanted = wanted_pairs(source.transforms, model, robot) if source.transforms else None
        library = library_of(robot, name, defaults, options, stamp, wanted)
        reference = Reference(mechanics, values_of_arguments)
        files = language_named(options.language).files(library, reference, parameters)
    except OverflowError as error:
        raise GenerationError(str(error)) from None
    files[NAME] = manifest_text(stamp, options, source.bindings, source.transforms, files)
    return library, files


def _inputs(analysis: Analysis, choice: str) -> list[str]:
    """Return the parameters that stay inputs, in the order of the document."""
    names = [str(parameter.name) for parameter in analysis.model.parameters]
    unbound = {name for name in names if analysis.context.values.get(name) is None}
    if choice == "all":
        return names
    chosen = set() if choice == "unbound" else {n.strip() for n in choice.split(",") if n.strip()}
    for name in sorted(chosen - set(names)):
        close = hint(nearest_name(name, names))
        raise GenerationError(f"--parameters: there is no parameter '{name}'{close}")
    return [name for name in names if name in unbound | chosen]


def _typed(options: Options, source: Source) -> str:
    """Return what gives the same, as it could be typed in the folder of the document."""
    words = ["kindsl", "generate", *(source.places or [source.name])]
    words += ["--language", options.language, "--name", options.prefix]
    words += ["--real", options.real, "--parameters", options.parameters]
    words += ["--quantities", ",".join(options.quantities)]
    words += ["--single-header"] if options.is_single_header else []
    for name, value in source.bindings.items():
        words += ["--param", f"{name}={value!r}"]
    return command_line(words)
