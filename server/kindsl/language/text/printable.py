"""Text that a terminal or a one-line message can show."""

_BLANKS = "\t\u00a0\u3000"


def printable(text: str) -> str:
    """Return a text that moves no cursor, each strange character replaced by one sign.

    Strange are control and format characters but the tab, and undecodable bytes as
    `surrogateescape` leaves them.
    """
    if text.isprintable():
        return text
    return "".join(
        character if character.isprintable() or character in _BLANKS else "\ufffd"
        for character in text
    )
