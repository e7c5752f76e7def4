"""Names of documents: URIs as clients spell them, one key for all spellings, and paths."""

import re
from functools import lru_cache
from pathlib import Path
from urllib.parse import unquote, urlsplit

from pygls.uris import to_fs_path

_THIS_MACHINE = re.compile(r"^file://localhost/", re.IGNORECASE)
_DRIVE = re.compile(r"^(file:///)([A-Za-z]):")


@lru_cache(1 << 14)
def key(uri: str) -> str:
    """Return one name for all spellings: decoded, this machine unnamed, the drive in lower case."""
    decoded = _THIS_MACHINE.sub("file:///", unquote(uri))
    return _DRIVE.sub(lambda drive: f"{drive[1]}{drive[2].lower()}:", decoded)


def path(uri: str) -> Path | None:
    """Return the file that a URI names, None when it names none (untitled, version control)."""
    name = to_fs_path(_THIS_MACHINE.sub("file:///", uri)) if uri.startswith("file:") else None
    return Path(name) if name else None


def uri(file: Path) -> str:
    """Return the URI of a file."""
    return file.absolute().as_uri()


@lru_cache(1 << 14)
def basename(uri: str) -> str:
    """Return the last part of a URI's path."""
    return unquote(urlsplit(uri).path).rpartition("/")[2]
