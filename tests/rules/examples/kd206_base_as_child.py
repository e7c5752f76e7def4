"""Documents in which KD206 finds nothing, and in which it finds something."""

from tests.support.examples import link, robot


def _leg(children: str) -> str:
    links = link("leg", 1, children), link("foot", 2)
    return robot(*links, base="leg via hip", joints="hip knee")


GOOD = (_leg("foot via knee"),)
BAD = (_leg("ground via knee"),)
