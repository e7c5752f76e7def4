"""What all tests share.

Properties are tried on the same values everywhere, without a clock. Programs that tests start can
be interrupted, even if the tests themselves run in the background of a shell, which keeps
interrupts from all that it starts so.
"""

import gc
import signal
from collections.abc import Generator

import pytest
from hypothesis import settings
from tests.delays.injected import inject
from tests.support.published import ABSENT, CORPUS

settings.register_profile("kindsl", deadline=None, derandomize=True)
settings.load_profile("kindsl")
inject()

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Collect garbage when all tests are there, and never again among thousands of them."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.collect()
        gc.freeze()
        gc.enable()


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    """Skip what needs published models where they are absent: one line in the summary."""
    if not CORPUS.is_dir() and item.get_closest_marker("published"):
        pytest.skip(ABSENT)
