"""Documents in which KD003 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link

_LINK = link("upper", 1)

GOOD = ("/* the first one */\n" + _LINK,)
BAD = (Example("/* the first one\n" + _LINK, fixed="/* the first one */\n" + _LINK),)
