"""One page that holds everything: the viewer, the state, working sliders, and no server."""

import base64
import hashlib
import struct
from collections.abc import Iterable, Sequence

from kindsl.preview.assets import SCRIPTS, STYLES, assets, page
from kindsl.scene.messages import Message, encode

_POLICY = (
    "default-src 'none'; script-src {hashes}; style-src 'unsafe-inline'; img-src data: blob:; "
    "base-uri 'none'; form-action 'none'"
)


def exported_page(state: Iterable[Message]) -> str:
    """Return a page that shows a state from the file system.

    Only its own scripts may run in it, told by their hashes, and it may not reach any address.

    Args:
        state: What a new tab would be sent.

    Raises:
        PreviewUnavailableError: If meshcat is not installed.
    """
    frames = base64.b64encode(_joined(state)).decode("ascii")
    data = f'<script id="embedded-state" type="text/plain">{frames}</script>'
    return sealed_page([assets()[name].content for name in SCRIPTS], data)


def sealed_page(scripts: Sequence[str], data: str = "") -> str:
    """Return the page as one text, which may run these scripts only and reach no address.

    Args:
        scripts: The texts of its scripts.
        data: An element to put before them.

    Raises:
        PreviewUnavailableError: If meshcat is not installed.
    """
    policy = _POLICY.format(hashes=" ".join(map(_hash, scripts)))
    head = (
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        f"<style>{''.join(assets()[name].content for name in STYLES)}</style>"
    )
    return page(head, "\n".join([data, *(f"<script>{script}</script>" for script in scripts)]))


def _joined(state: Iterable[Message]) -> bytes:
    """Return the messages' frames one after the other, each after its length in four bytes."""
    frames = (encode(message) for message in state)
    return b"".join(struct.pack(">I", len(frame)) + frame for frame in frames)


def _hash(script: str) -> str:
    digest = hashlib.sha256(script.encode()).digest()
    return f"'sha256-{base64.b64encode(digest).decode('ascii')}'"
