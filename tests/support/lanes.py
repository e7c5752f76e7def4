"""Who runs which tests: a file stays together, and only one worker drives browsers.

Two browsers that draw without a graphics card keep two cores from everything else, and what they
show comes late. Their tests take long, too: they begin first.
"""

from xdist.scheduler import LoadScopeScheduling

DRIVING = ("tests/preview/", "tests/typist/", "tests/vscode/", "tests/web/")


def drives_a_browser(nodeid: str) -> bool:
    """Whether a test is in a folder of those that drive browsers."""
    return nodeid.startswith(DRIVING)


class Lanes(LoadScopeScheduling):
    """Hands out files, but all that drive browsers together."""

    def _split_scope(self, nodeid: str) -> str:
        return "browsers" if drives_a_browser(nodeid) else nodeid.partition("::")[0]
