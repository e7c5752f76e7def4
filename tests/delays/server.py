"""The language server, late at random moments."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

from tests.delays.injected import inject

from kindsl.frontends.cli.language_server import main

inject()
main()
