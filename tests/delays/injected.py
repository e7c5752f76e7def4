"""Delays at random moments, as a busy machine makes them: in the server, the worker or the page.

On the page either frames are late or the server's messages are.
With `KINDSL_DELAYS=worker:7` in the environment all tests run so, who is late and the seed; see
`test_delays.py`. A test that fails then waits for a time to pass instead of for what it is about.
"""

import os
import random
import time
from collections.abc import Callable
from functools import wraps
from typing import Any

WHO, _, SEED = os.environ.get("KINDSL_DELAYS", "").partition(":")
_LONGEST = {"server": 0.04, "worker": 0.08}  # seconds, before each message or job
_ONE_IN = 3

_RANDOM = """(() => {
  let state = SEED + 1;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
""".replace("SEED", SEED or "0")
# A frame comes when it is drawn, up to a fifth of a second late; one that is cancelled never.
_FRAMES = """
  const frame = window.requestAnimationFrame.bind(window);
  const waiting = new Set();
  let last = 0;
  window.requestAnimationFrame = (draw) => {
    const id = ++last;
    waiting.add(id);
    const wait = random() < 0.3 ? 200 * random() : 0;
    setTimeout(() => frame((time) => { if (waiting.delete(id)) draw(time); }), wait);
    return id;
  };
  window.cancelAnimationFrame = (id) => waiting.delete(id);
})()"""
# What the server says comes up to a fifth of a second late, in its order.
_MESSAGES = """
  const line = Object.getOwnPropertyDescriptor(WebSocket.prototype, "onmessage");
  Object.defineProperty(WebSocket.prototype, "onmessage", { ...line, set(take) {
    let before = Promise.resolve();
    line.set.call(this, (event) => {
      before = before.then(() => new Promise((done) => setTimeout(done, 200 * random())));
      before.then(() => take.call(this, event));
    });
  } });
})()"""
# What a page runs before its own scripts, if it is the one that shall be late.
ON_PAGE = {"frames": _RANDOM + _FRAMES, "messages": _RANDOM + _MESSAGES}.get(WHO)


def inject() -> None:
    """Make this process late, if it is the one that shall be."""
    generator = random.Random(SEED)
    if WHO == "server":
        from kindsl.frontends.lsp.wire.protocol import KindslProtocol
        from kindsl.frontends.preview.documents import DocumentPreviews

        _delay(KindslProtocol, "receive", generator)
        _delay(DocumentPreviews, "receive", generator)
    elif WHO == "worker":
        from kindsl.frontends.lsp.session.worker import Worker

        _delay(Worker, "_do_next", generator)


def _delay(owner: type, name: str, generator: random.Random) -> None:
    work: Callable[..., Any] = getattr(owner, name)

    @wraps(work)
    def late(*arguments: Any, **named: Any) -> Any:
        if generator.randrange(_ONE_IN) == 0:
            time.sleep(generator.random() * _LONGEST[WHO])
        return work(*arguments, **named)

    setattr(owner, name, late)
