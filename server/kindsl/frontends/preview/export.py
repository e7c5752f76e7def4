"""One page that holds everything: the viewer, the state, working sliders, and no server."""

import base64
import hashlib
from collections.abc import Iterable, Sequence

from kindsl.frontends.preview.assets import SCRIPTS, STYLES, assets, page
from kindsl.robots.scene.encoding import encode
from kindsl.robots.scene.messages import Change, Part

_POLICY = (
    "default-src 'none'; script-src {hashes}; style-src 'unsafe-inline'; img-src data: blob:; "
    "base-uri 'none'; form-action 'none'"
)


def exported_page(state: Iterable[Part]) -> str:
    """Return a page that shows a state from the file system.

    Only its own scripts may run in it, told by their hashes, and it may not reach any address.

    Raises:
        PreviewUnavailableError: If meshcat is not installed.
    """
    whole = base64.b64encode(encode(Change(True, tuple(state)))).decode("ascii")
    data = f'<script id="embedded-state" type="text/plain">{whole}</script>'
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


def _hash(script: str) -> str:
    digest = hashlib.sha256(script.encode()).digest()
    return f"'sha256-{base64.b64encode(digest).decode('ascii')}'"
