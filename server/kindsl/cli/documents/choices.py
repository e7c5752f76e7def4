"""What the command line decides, put over what the configuration does."""

from typing import TYPE_CHECKING, NamedTuple

from kindsl.analysis.settings import Settings
from kindsl.config.decisions import Decisions, overridden
from kindsl.config.discovery import Configurations

if TYPE_CHECKING:
    from kindsl.config.configuration import Configuration


class Choices(NamedTuple):
    """The decisions of one run.

    Attributes:
        decisions: What the command line says.
        configurations: Where configuration files come from, None for nowhere.
    """

    decisions: Decisions = Decisions()
    configurations: Configurations | None = None

    def configuration_for(self, document: str) -> "Configuration | None":
        """Return the configuration that holds for a document.

        Raises:
            ConfigurationError: It says something wrong.
        """
        return self.configurations.above(document) if self.configurations else None

    def settings_for(self, document: str) -> Settings:
        """Return all that is decided for a document.

        Selecting rules on the command line forgets which the configuration selects and ignores;
        ignoring some adds to it.

        Raises:
            ConfigurationError: The configuration says something wrong.
        """
        configuration = self.configuration_for(document)
        settings = configuration.settings_for(document) if configuration else Settings()
        chosen = self.decisions
        if chosen.select is None and chosen.ignore is not None:
            chosen = chosen._replace(ignore=(*settings.ignore, *chosen.ignore))
        elif chosen.select is not None and chosen.ignore is None:
            chosen = chosen._replace(ignore=())
        return overridden(settings, chosen)
