"""What all tests share.

Properties are tried on the same values everywhere, without a clock. Programs that tests start can
be interrupted, even if the tests themselves run in the background of a shell, which keeps
interrupts from all that it starts so.
"""

import signal

from hypothesis import settings

settings.register_profile("kindsl", deadline=None, derandomize=True)
settings.load_profile("kindsl")

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
