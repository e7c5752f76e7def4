"""From a document and options to the text of all files."""

from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple

from kindsl import __version__
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.transforms import UnwritableNameError, transforms_document
from kindsl.language.text.nearest import hint, nearest_name
from kindsl.products.codegen.c_test_program import parameter_values
from kindsl.products.codegen.language import language_named
from kindsl.products.codegen.layouts import LAYOUTS
from kindsl.products.codegen.library import (
    NO_PAIRS,
    GenerationError,
    Library,
    Options,
    Stamp,
    library_of,
)
from kindsl.products.codegen.manifest import NAME, manifest_text
from kindsl.products.codegen.names_in_code import command_line, file_name
from kindsl.products.codegen.reference import Reference, independent_contacts, sample
from kindsl.products.codegen.resistance import refuse_unresisted
from kindsl.products.codegen.wanted import restricted, wanted_pairs, without_pairs
from kindsl.robots.interchange.generated_folder import digest, robot_record
from kindsl.robots.mechanism.build import Mechanism
from kindsl.robots.mechanism.symbolic import symbolic_robot


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
        options: Choice of the files and functions.
        stamp: Origin that the files tell; None for the truth.

    Raises:
        GenerationError: A quantity, name or pair of frames cannot be generated.
        kindsl.robots.mechanism.errors.ModelError: The document describes no mechanism.
    """
    language = language_named(options.language)
    options = replace(options, quantities=language.quantities or options.quantities)
    model, values = source.analysis.model, source.analysis.context.values
    inputs = _inputs(source.analysis, options.parameters)
    joints = {} if language.is_rigid else source.analysis.settings.joints
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
    robot = symbolic_robot(model, values, inputs, joints)
    if language.is_rigid:
        mechanics = Mechanism(mechanics.linkage)
    values_of_arguments = sample(mechanics.bodies)
    refuse_unresisted(
        options.quantities, mechanics.bodies, values_of_arguments["q"],
        are_chosen=not language.quantities,
    )  # fmt: skip
    try:
        listed = source.transforms
        if listed is None and language.makes_transforms:
            listed = transforms_document(model)
        wanted = wanted_pairs(listed, model, robot) if listed else NO_PAIRS
        if options.frames is not None:
            lacking = without_pairs(wanted, options.frames) if language.makes_transforms else []
            robot, wanted = restricted(robot, wanted, options.frames)
            for frame in lacking:
                message = f"no pair of the transforms document has the frame '{frame}'"
                raise GenerationError(f"--frames: {message}")
        library = library_of(
            robot, name, defaults, options, stamp, wanted, has_loops=language.has_loops
        )
        library = replace(
            library, parameter_kinds=_kinds(model), version=source.analysis.settings.version
        )
        for function in library.functions.get("contact_dynamics", ()):
            active = independent_contacts(mechanics, values_of_arguments["q"], function.about)
            values_of_arguments["active"] = active
        reference = Reference(mechanics, values_of_arguments, parameters)
        files = language.files(library, reference)
    except (OverflowError, UnwritableNameError) as error:
        raise GenerationError(str(error)) from None
    numbers = robot_record(mechanics.linkage)
    files[NAME] = manifest_text(stamp, options, source.bindings, source.transforms, files, numbers)
    return library, files


def _kinds(model: Model) -> dict[str, frozenset[str]]:
    """Return the classes of values that each parameter stands in."""
    return {
        str(parameter.name): frozenset(use.kind for use in parameter.uses)
        for parameter in model.parameters
    }


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
    words += ["--language", options.language]
    heeded = language_named(options.language).options
    words += ["--name", options.prefix] if "--name" in heeded else []
    words += ["--real", options.real, "--parameters", options.parameters]
    words += ["--quantities", ",".join(options.quantities)] if "--quantities" in heeded else []
    words += ["--single-header"] if options.is_single_header else []
    words += ["--layout", options.layout] if options.layout != LAYOUTS[0] else []
    words += ["--runtime"] if options.has_runtime else []
    words += ["--namespace", options.namespace] if options.namespace else []
    words += ["--sources"] if options.has_sources else []
    words += ["--frames", ",".join(options.frames)] if options.frames is not None else []
    for name, value in source.bindings.items():
        words += ["--param", f"{name}={value!r}"]
    return command_line(words)
