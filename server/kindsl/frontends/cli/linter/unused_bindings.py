"""KD404 and KD902 over a run of the linter: what configuration files name in vain."""

import os
from collections.abc import Collection, Mapping, Sequence

from kindsl.frontends.cli.documents.choices import Choices
from kindsl.frontends.cli.outcome import LintedFile
from kindsl.judgement.config import unused_bindings as vain
from kindsl.judgement.config.configuration import Configuration
from kindsl.judgement.config.robots import walked
from kindsl.judgement.config.unused_bindings import unreadable_twins
from kindsl.judgement.rules.checks.kd404_unused_binding import unused_bindings as vain_bindings


def unused_bindings(
    files: Sequence[LintedFile],
    configurations: Mapping[str, Configuration],
    choices: Choices,
    excluded: Collection[str],
) -> list[LintedFile]:
    """Return each configuration file with unused bindings, with the findings.

    Args:
        files: The linted files.
        configurations: The configuration that held for each of them, by the path shown.
        choices: Decisions of the command line.
        excluded: Names of folders to leave out.
    """
    used = {file.path: vain.Names(file.parameters, file.joints) for file in files}
    found = []
    for path, configuration in sorted({c.path: c for c in configurations.values()}.items()):
        own = {p: names for p, names in used.items() if configurations.get(p) is configuration}
        folder = os.path.dirname(os.path.abspath(path))
        others = (robot for robot in walked(folder, excluded) if isinstance(robot, str))
        settings = choices.settings_for(path)
        findings = vain.unused_bindings(configuration, settings, own, others)
        findings += unreadable_twins(configuration, settings)
        if findings:
            found.append(LintedFile(path, configuration.text, findings))
    return found


def unused_on_command_line(files: Sequence[LintedFile], choices: Choices) -> list[str]:
    """Return a sentence for each `--param` that no document uses; none if there are none."""
    known: frozenset[str] = frozenset().union(*(file.parameters for file in files))
    given = choices.decisions.bindings
    names = [name for name in given if given[name].origin == "--param"]
    unused = vain_bindings(names, sorted(known)) if files else {}
    return [f"warning: --param {name}: {message}" for name, message in unused.items()]
