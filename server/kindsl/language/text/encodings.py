"""The encoding of a file: UTF-8, or the one that an XML declaration names."""

import re

_DECLARED = r"""<\?xml\s[^>]*?\bencoding\s*=\s*["']([A-Za-z][\w.-]*)["']"""
# As far as the declaration of a file reaches at most, in characters.
_HEAD = 200
_UTF_16, _MARK = (b"\xff\xfe", b"\xfe\xff"), "\ufeff"
_UTF_8 = ("utf-8", "utf8", "us-ascii", "ascii")
_ALL_BYTES, _ASCII = bytes(range(256)), bytes(range(32, 127))


def decoded(content: bytes) -> str:
    """Return a file's text, line ends untouched; bytes that are not UTF-8 as surrogates.

    Of XML in another encoding that it declares, where XML parsers read that: one of a byte for each
    character, or UTF-16 with a mark, which the text begins with.
    """
    name = declared_encoding(content[:_HEAD].decode("latin-1"))
    try:
        if content.startswith(_UTF_16):
            text = content.decode("utf-16")
            if declared_encoding(text).lower() == "utf-16":
                return _MARK + text
        elif _is_of_single_bytes(name):
            return content.decode(name)
    except UnicodeError:
        pass
    return content.decode("utf-8", "surrogateescape")


def encoded(text: str) -> bytes:
    """Return a text as its file has it; bytes that were not UTF-8 when read stay as they were."""
    name = declared_encoding(text.removeprefix(_MARK))
    try:
        if text.startswith(_MARK) and name.lower() == "utf-16":
            return text.removeprefix(_MARK).encode(name)
        if _is_of_single_bytes(name) and not text.startswith(_MARK):
            return text.encode(name)
    except UnicodeError:
        pass
    return text.encode("utf-8", "surrogateescape")


def declared_encoding(text: str) -> str:
    """Return the encoding that the text of an XML file declares, empty without one."""
    declared = re.match(_DECLARED, text[:_HEAD]) if text.startswith("<?xml") else None
    return declared[1] if declared is not None else ""


def _is_of_single_bytes(name: str) -> bool:
    """Return whether an encoding other than UTF-8 has a byte for each character."""
    if not name or name.lower() in _UTF_8:
        return False
    try:
        characters = _ALL_BYTES.decode(name, "replace")
        return len(characters) == 256 and _ASCII.decode(name) == _ASCII.decode()
    except (LookupError, ValueError):
        return False
