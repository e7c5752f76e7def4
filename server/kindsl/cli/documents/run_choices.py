"""From the options to the decisions of a run."""

from typing import Any

from kindsl.cli.documents.choices import Choices
from kindsl.config.decisions import Decisions
from kindsl.config.discovery import Configurations
from kindsl.semantics.parameters import Binding


def choices_of(args: Any) -> Choices:
    """Return what the command line decides.

    Raises:
        ConfigurationError: A file of parameters, or the configuration file named, is wrong.
    """
    targets = getattr(args, "target", None)
    select, ignore = getattr(args, "select", None), getattr(args, "ignore", None)
    decisions = Decisions(
        None if targets is None else frozenset(targets),
        None if select is None else tuple(select),
        None if ignore is None else tuple(ignore),
        bindings=_bindings(args),
    )
    if args.isolated:
        return Choices(decisions)
    configurations = Configurations(args.config)
    if args.config is not None:
        configurations.above(args.config)
    return Choices(decisions, configurations)


def _bindings(args: Any) -> dict[str, Binding]:
    found: dict[str, Binding] = {}
    if args.params is not None:
        from kindsl.config.reading import read_parameters

        found = read_parameters(args.params)
    found.update({name: Binding(value, origin="--param") for name, value in args.param})
    return found
