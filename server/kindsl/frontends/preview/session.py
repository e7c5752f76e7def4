"""The address of a document's last server, so that open pages find the next one.

Kept in a folder that only its owner can read, because a token opens the preview.
"""

import hashlib
import json
import os
import stat
import tempfile
from contextlib import suppress
from pathlib import Path

from kindsl.frontends.preview.access import Access


def last_session(name: str) -> Access | None:
    """Return the access to the last server of a name, None if there is none to be trusted."""
    folder = _folder()
    if folder is None:
        return None
    with suppress(OSError, ValueError, KeyError, TypeError):
        data = json.loads(_file(folder, name).read_text(encoding="utf-8"))
        return Access(str(data["token"]), int(data["port"]))
    return None


def remember(name: str, session: Access) -> None:
    """Keep port and token for the next server; without a safe folder it is not kept."""
    folder = _folder()
    if folder is None:
        return
    with suppress(OSError):
        file = _file(folder, name)
        descriptor = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
        with os.fdopen(descriptor, "w", encoding="utf-8") as stream:
            json.dump({"port": session.port, "token": session.token}, stream)


def _file(folder: Path, name: str) -> Path:
    digest = hashlib.sha256(name.encode(errors="surrogatepass")).hexdigest()[:16]
    return folder / f"preview-{digest}.json"


def _folder() -> Path | None:
    """Return the folder for sessions, None if others could read or have made it."""
    runtime = os.environ.get("XDG_RUNTIME_DIR") or os.environ.get("LOCALAPPDATA")
    user = str(os.getuid()) if hasattr(os, "getuid") else "user"
    folder = Path(runtime, "kindsl") if runtime else Path(tempfile.gettempdir(), f"kindsl-{user}")
    try:
        folder.mkdir(mode=0o700, exist_ok=True)
        status = folder.lstat()
    except OSError:
        return None
    return folder if _is_private(status) else None


def _is_private(status: os.stat_result) -> bool:
    if not stat.S_ISDIR(status.st_mode):
        return False
    return not hasattr(os, "getuid") or (
        status.st_uid == os.getuid() and not stat.S_IMODE(status.st_mode) & 0o077
    )
