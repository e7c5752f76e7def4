"""`python -m kindsl`, for where the command is not on the path."""

import sys

from kindsl.frontends.cli.main import main

sys.exit(main())
