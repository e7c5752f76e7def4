"""The decisions of the command line, which override those of the configuration."""

from typing import TYPE_CHECKING, Any, NamedTuple

from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.config.decisions import Decisions, overridden
from kindsl.judgement.config.discovery import Configurations
from kindsl.language.semantics.parameters import Binding

if TYPE_CHECKING:
    from kindsl.judgement.config.configuration import Configuration


class Choices(NamedTuple):
    """The decisions of one run.

    Attributes:
        decisions: Those of the command line.
        configurations: Where configuration files come from, None for nowhere.
        editor: What an editor is set to.
        floating: Whether the root of another format floats.
    """

    decisions: Decisions = Decisions()
    configurations: Configurations | None = None
    editor: Settings | None = None
    floating: bool = False

    def afresh(self) -> "Choices":
        """Return these choices with configuration files to be read again."""
        known = self.configurations
        return self._replace(configurations=known and Configurations(known.fixed))

    def configuration_for(self, document: str) -> "Configuration | None":
        """Return the configuration that applies to a document.

        Raises:
            ConfigurationError: It says something wrong.
        """
        return self.configurations.above(document) if self.configurations else None

    def settings_for(self, document: str) -> Settings:
        """Return all decisions for a document; see `decided_for`."""
        return self.decided_for(document)[1]

    def decided_for(self, document: str) -> "tuple[Configuration | None, Settings]":
        """Return the configuration that applies to a document, and all decisions for it.

        Selecting rules on the command line forgets which the configuration selects and ignores;
        ignoring some adds to it.

        Raises:
            ConfigurationError: The configuration says something wrong.
        """
        configuration = self.configuration_for(document)
        settings = configuration.settings_for(document) if configuration else Settings()
        if self.editor is not None:
            from kindsl.judgement.config.editor_settings import merged

            settings = merged(settings, self.editor)
        chosen = self.decisions
        if chosen.select is None and chosen.ignore is not None:
            chosen = chosen._replace(ignore=(*settings.ignore, *chosen.ignore))
        elif chosen.select is not None and chosen.ignore is None:
            chosen = chosen._replace(ignore=())
        return configuration, overridden(settings, chosen)


def choices_of(args: Any) -> Choices:
    """Return the decisions of the command line.

    Raises:
        ConfigurationError: A file of parameters, or the configuration file named, is wrong.
    """
    editor = getattr(args, "editor_settings", None)
    configurations = None if args.isolated else Configurations(args.config)
    if configurations is not None and args.config is not None:
        configurations.above(args.config)
    bindings: dict[str, Binding] = {}
    if args.params is not None:
        from kindsl.judgement.config.configuration_reading import read_parameters

        bindings = read_parameters(args.params)
    bindings |= {name: Binding(value, origin="--param") for name, value in args.param}
    targets = getattr(args, "target", None)
    select, ignore = getattr(args, "select", None), getattr(args, "ignore", None)
    decisions = Decisions(
        None if targets is None else frozenset(targets),
        None if select is None else tuple(select),
        None if ignore is None else tuple(ignore),
        bindings=bindings,
    )
    floating = getattr(args, "floating_base", False)
    return Choices(decisions, configurations, editor, floating)
