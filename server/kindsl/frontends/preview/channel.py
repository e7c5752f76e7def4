"""The state of one document's preview, and the tabs that show it."""

import asyncio
from collections.abc import Awaitable, Callable, Iterable

from kindsl.frontends.preview.changes import Messages, changes, key_of, keyed
from kindsl.robots.scene.messages import Change, Part


class Tab:
    """One open page. What it has not taken yet waits here, the last value of each property.

    So a tab that stalls costs at most one state, and nobody waits for it.
    """

    def __init__(self, write: Callable[[Change], Awaitable[None]]) -> None:
        """Take the function that writes a change and returns when the page has taken it."""
        self._write = write
        self._waiting: Messages = {}
        self._is_whole = False
        self._has_work = asyncio.Event()

    def begin(self, state: Iterable[Part]) -> None:
        """Let the page have a whole state."""
        self._waiting, self._is_whole = keyed(state), True
        self._has_work.set()

    def send(self, message: Part) -> None:
        """Let the page have a message as soon as it takes it."""
        key = key_of(message)
        if key.type == "delete":
            below = f"{key.path}/"
            for each in [k for k in self._waiting if f"{k.path}/".startswith(below)]:
                del self._waiting[each]
        # A later place in the queue, so that what follows a deletion stays after it.
        self._waiting.pop(key, None)
        self._waiting[key] = message
        self._has_work.set()

    async def run(self) -> None:
        """Write what waits, until cancelled."""
        while True:
            await self._has_work.wait()
            self._has_work.clear()
            change = Change(self._is_whole, tuple(self._waiting.values()))
            self._waiting, self._is_whole = {}, False
            await self._write(change)


class Channel:
    """Sends each change of a state to all tabs, and the whole state, once, to a new one.

    The state is held in named parts, whose paths are disjoint.
    """

    def __init__(self) -> None:
        self._parts: dict[str, Messages] = {}
        self._tabs: set[Tab] = set()

    @property
    def state(self) -> list[Part]:
        """One message for each property."""
        return [message for part in self._parts.values() for message in part.values()]

    def join(self, tab: Tab) -> None:
        """Send a tab the whole state, and from now on its changes."""
        tab.begin(self.state)
        self._tabs.add(tab)

    def leave(self, tab: Tab) -> None:
        """Forget a tab."""
        self._tabs.discard(tab)

    def replace(self, part: str, messages: Iterable[Part] | Messages) -> None:
        """Make `messages` the state of a part; what is the same is not sent again."""
        new = messages if isinstance(messages, dict) else keyed(messages)
        for message in changes(self._parts.get(part, {}), new):
            self.announce(message)
        self._parts[part] = new

    def put(self, part: str, message: Part, sender: Tab | None = None) -> None:
        """Set one property and send it to all tabs except the sender."""
        self._parts.setdefault(part, {})[key_of(message)] = message
        for tab in self._tabs - {sender}:
            tab.send(message)

    def announce(self, message: Part) -> None:
        """Send a message that is no part of the state."""
        for tab in self._tabs:
            tab.send(message)
