"""What a page makes of messages, without a browser."""

from collections.abc import Iterable
from typing import Any

from kindsl.frontends.preview.changes import Messages, key_of
from kindsl.robots.scene.encoding import as_dict
from kindsl.robots.scene.messages import Part


class Page:
    """Keeps the last value of each property, as the page does."""

    def __init__(self, messages: Iterable[Part] = ()) -> None:
        self.state: Messages = {}
        for message in messages:
            self.take(message)

    def take(self, message: Part) -> None:
        if message.type == "delete":
            path = message.path
            below = path + "/"
            self.state = {
                key: value
                for key, value in self.state.items()
                if key.path != path and not key.path.startswith(below)
            }
            return
        self.state[key_of(message)] = message

    def at(self, path: str) -> dict[str, Any]:
        """Return the properties of a path by type."""
        return {key.type: as_dict(value) for key, value in self.state.items() if key.path == path}
