"""Names of a document as names in generated code."""

import keyword
import re
import shlex
from collections.abc import Iterable

from kindsl.language.text.distinct import distinct

_UNSAFE = re.compile(r"[^A-Za-z0-9_]")
_COMMENT_END = re.compile(r'[*"\\]|[^\w\s!-~]|[^\S ]')
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")

# Of C, C++ and Python; what one of them reserves is no name in any. At the end, macros of headers,
# and what RobCoGen's structures of parameters have beside these.
_C_AND_CPP = """
    alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t
    char32_t char8_t class compl concept const const_cast consteval constexpr constinit
    continue co_await co_return co_yield decltype default delete do double dynamic_cast else
    enum explicit export extern false float for friend goto if inline int long main mutable
    namespace new noexcept not not_eq nullptr operator or or_eq private protected public
    register reinterpret_cast requires restrict return short signed sizeof static
    static_assert static_cast std struct switch template this thread_local throw true try
    typedef typeid typename union unsigned using virtual void volatile wchar_t while xor
    xor_eq errno linux unix stdin stdout stderr math_errhandling
    BUFSIZ EDOM EILSEQ EINTR EIO ELOOP EOF ERANGE EROFS ETIME EXIT_FAILURE EXIT_SUCCESS
    FILENAME_MAX FOPEN_MAX FP_INFINITE FP_NAN FP_NORMAL FP_SUBNORMAL FP_ZERO HUGE_VAL HUGE_VALF
    HUGE_VALL INFINITY INT_MAX INT_MIN LINE_MAX LONG_MAX LONG_MIN MATH_ERRNO MAXFLOAT MAX_INPUT
    M_1_PI M_2_PI M_E M_LN10 M_LN2 M_PI M_PI_2 M_PI_4 M_SQRT2 NAME_MAX NAN NULL NZERO PATH_MAX
    RAND_MAX SEEK_CUR SEEK_END SEEK_SET SNAN TMP_MAX defaults
"""
RESERVED = frozenset(_C_AND_CPP.split()) | frozenset(keyword.kwlist)

# Functions and namespaces that headers declare, and the headers themselves: members may have
# these names, a library's namespace and header may not.
_TAKEN = """
    abort abs access acct alarm assert atexit bind brk ceil clock close complex connect copysign cos
    ctype daylight div drem dup Eigen environ erf exit exp fabs floor fma fmax fmin fmod fork free
    frexp gamma iit index isatty j0 j1 jn kill labs ldexp lgamma limits link listen locale log logb
    malloc math memory modf nan nice open pause pipe pow puts raise rand random read remove rename
    rint rmdir round scalb select send setjmp signal significand sin sleep socket sqrt stat stddef
    stdio stdlib string strings swab sync system tan tempnam tgamma time times timezone trunc
    truncate unistd unlink vector wait wchar write y0 y1 yn
"""
_TAKEN_IN_HEADERS = frozenset(_TAKEN.split())


class UnusableNameError(ValueError):
    """A name cannot be used in generated code."""


def prefix_of(robot: str, given: str | None) -> str:
    """Return what all names of a library begin with.

    Args:
        given: The name asked for, if any.

    Raises:
        UnusableNameError: What was asked for is not a free name in C, C++ and Python.
    """
    if given is not None:
        if not _NAME.fullmatch(given) or given in RESERVED | _TAKEN_IN_HEADERS:
            what = "a reserved word" if _NAME.fullmatch(given) else "not a valid name"
            raise UnusableNameError(f"--name: '{given}' is {what} in C, C++ or Python")
        return given
    return whole_name(robot.lower()) if robot else "robot"


def namespace_of(given: str) -> str:
    """Return a nested namespace of C++ as it was asked for.

    Raises:
        UnusableNameError: One of its names is not free there.
    """
    for name in given.split("::"):
        if not _NAME.fullmatch(name) or name in RESERVED | {"Eigen"}:
            what = "a name that is taken" if _NAME.fullmatch(name) else "not a valid name"
            raise UnusableNameError(f"--namespace: '{name}' is {what} in C++")
    if "iit" in given.split("::")[1:] or given in ("iit", "iit::rbd", "std"):
        raise UnusableNameError(f"--namespace: '{given}' would hide names of the headers 'iit/rbd'")
    return given


def whole_name(name: str) -> str:
    """Return the nearest name that a library may have, which is its namespace's and header's."""
    safe = identifier(name)
    return f"{safe}_" if safe in _TAKEN_IN_HEADERS else safe


def identifier(name: str) -> str:
    """Return the nearest name that all languages take."""
    safe = _UNSAFE.sub("_", name).strip("_") or "x"
    if safe[0].isdigit():
        safe = f"x{safe}"
    return f"{safe}_" if safe in RESERVED else safe


def file_name(name: str) -> str:
    """Return a file's name as it may stand in a comment of any language."""
    return re.sub(r"[^\w.+ -]", "_", name)


def command_line(words: Iterable[str]) -> str:
    """Return words as they could be typed, such that no comment of any language ends in them."""
    return shlex.join(_COMMENT_END.sub("_", word) for word in words)


def identifiers(names: Iterable[str]) -> dict[str, str]:
    """Return each name's form in code; two names never share one."""
    known = list(names)
    return dict(zip(known, distinct(map(identifier, known)), strict=True))
