"""The one folder that assistants read and write: what leads out of it is refused."""

from pathlib import Path

from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.config.discovery import Configurations, nearest_configuration
from kindsl.judgement.config.errors import ConfigurationError
from kindsl.language.text.encodings import decoded, encoded
from kindsl.language.text.regular import NotRegularError, require_regular
from kindsl.language.text.writing import write_file

_LARGEST = 10_000_000  # bytes: larger than any robot, smaller than what stops a machine


class ToolError(Exception):
    """A tool cannot do what it was asked; one sentence that says what is right."""


class Folder:
    """A folder and all below it; `root` is absolute, links resolved."""

    def __init__(self, root: Path) -> None:
        self.root = root.resolve()

    def path(self, given: str) -> Path:
        """Return where a path leads, links followed.

        Raises:
            ToolError: It leads out of the folder, or is no path.
        """
        try:
            found = (self.root / given).resolve()
        except (OSError, ValueError, RuntimeError):
            raise ToolError(f"'{given}' is not a path") from None
        if not found.is_relative_to(self.root):
            raise ToolError(f"'{given}' leads out of the folder that this server was started in")
        return found

    def read(self, given: str) -> str:
        """Return the text of a file, bytes that are no UTF-8 as surrogates.

        Raises:
            ToolError: It cannot be read.
        """
        path = self.path(given)
        try:
            require_regular(str(path))
            if path.stat().st_size > _LARGEST:
                raise ToolError(f"'{given}' is larger than {_LARGEST // 1_000_000} MB")
            return decoded(path.read_bytes())
        except FileNotFoundError:
            raise ToolError(f"there is no file '{given}' in {self.root}") from None
        except IsADirectoryError:
            raise ToolError(f"'{given}' is a folder; name a file in it") from None
        except NotRegularError as error:
            raise ToolError(f"'{given}' {error.strerror}") from None
        except OSError as error:
            raise ToolError(f"'{given}' cannot be read: {error.strerror}") from None

    def require_own_files(self, given: str) -> None:
        """Raise ToolError if a folder holds a link that leads out."""
        for path in sorted(self.path(given).rglob("*")):
            self.path(str(path.relative_to(self.root)))

    def write(self, given: str, text: str) -> None:
        """Make a file hold a text, wholly or not at all.

        Raises:
            ToolError: It cannot be written.
        """
        try:
            write_file(str(self.path(given)), encoded(text))
        except OSError as error:
            raise ToolError(f"'{given}' cannot be written: {error.strerror}") from None

    def settings_for(self, given: str) -> Settings:
        """Return what the nearest kindsl.toml in the folder says of a document.

        Raises:
            ToolError: The file says something wrong.
        """
        document = str(self.path(given))
        found = nearest_configuration(str(Path(document).parent))
        if found is None or not Path(found).resolve().is_relative_to(self.root):
            return Settings()
        try:
            configuration = Configurations(found).above(document)
        except ConfigurationError as error:
            raise ToolError(str(error)) from None
        return configuration.settings_for(document) if configuration else Settings()
