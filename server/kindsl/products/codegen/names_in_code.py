"""Names of a document as names in generated code."""

import errno
import keyword
import re
import shlex
import signal
from collections.abc import Iterable

from kindsl.language.text.distinct import distinct

_UNSAFE = re.compile(r"[^A-Za-z0-9_]")
_COMMENT_END = re.compile(r'[*"\\]|[^\w\s!-~]|[^\S ]')
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")

# Of C, C++ and Python; what one of them reserves is no name in any. At the end, macros of headers
# in small letters, and what RobCoGen's structures of parameters have beside these.
_WORDS = """
    alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t
    char32_t char8_t class compl concept const const_cast consteval constexpr constinit
    continue co_await co_return co_yield decltype default delete do double dynamic_cast else
    enum explicit export extern false float for friend goto if inline int long main mutable
    namespace new noexcept not not_eq nullptr operator or or_eq private protected public
    register reinterpret_cast requires restrict return short signed sizeof static
    static_assert static_cast std struct switch template this thread_local throw true try
    typedef typeid typename union unsigned using virtual void volatile wchar_t while xor
    xor_eq complex errno linux unix stdin stdout stderr math_errhandling sched_priority
    L_ctermid L_cuserid L_tmpnam P_tmpdir defaults
"""
_CONSTANTS = (name for module in (errno, signal) for name in dir(module) if name.isupper())
RESERVED = frozenset((*_WORDS.split(), *keyword.kwlist, *_CONSTANTS))

# Further macros of the headers of C, POSIX and Eigen, by their families; rather none too many, as
# joints are enumerators in capitals.
_MACRO = re.compile(
    r"""
    I | NAN | INFINITY | NULL | W?EOF | BUFSIZ | MAXFLOAT | NZERO | PIPE_BUF | CSIGNAL | EHWPOISON
    | (BIG|LITTLE|PDP)_ENDIAN | BYTE_ORDER | (CHAR|LONG|WORD)_BIT | DECIMAL_DIG | NFDBITS
    | (U?INT|PTRDIFF|SIG_|S?SIZE|[SUW]?CHAR|BOOL|U?L?LONG|U?SHRT|WINT)\w*_(MAX|MIN|WIDTH)
    | (AIO_PRIO_DELTA|BC_[A-Z]+|CHARCLASS_NAME|COLL_WEIGHTS|DELAYTIMER|EXPR_NEST|FILENAME|FOPEN
      |HOST_NAME|IOV|LINE|LOGIN_NAME|MB_CUR|MB_LEN|MQ_PRIO|NAME|NGROUPS|NL_[A-Z]+|PATH|RAND|RE_DUP
      |RTSIG|SEM_VALUE|TMP|TTY_NAME|XATTR_[A-Z]+)_MAX | NL_[A-Z]+MAX | MAX_(CANON|INPUT)
    | L?(DBL|FLT)_\w+ | (HUGE_VAL|SNAN)\w* | MATH_ERR\w+ | (PRI|SCN)[Xdioux]\w+
    | FP_(I|LL|NAN|NORMAL|SUBNORMAL|ZERO)\w*
    | M_(E|LN2|LN10|LOG2E|LOG10E|PI|PI_2|PI_4|1_PI|2_PI|2_SQRTPI|SQRT2|SQRT1_2)(l|f\w*)?
    | (ATOMIC|CLOCKS?|CLONE|CLOSE_RANGE|EIGEN|EXIT|ITIMER|PTHREAD|RENAME|SCHED|SEEK|TIMER)_\w+
    | LC_(ADDR|ALL|COLL|CTYPE|GLOBAL|IDENT|MEAS|MESS|MONE|NAME|NUM|PAPER|TELE|TIME)\w*
    | (ADJ|MOD|STA)_(CLK|CLOCKERR|DEL|ESTERR|FLL|FREQ|INS|MAXERR|MICRO|MODE|NANO|OFFSET|PLL|PPS
      |RONLY|SETOFF|STATUS|TAI|TICK|TIMECONST|UNSYNC)\w*
    | SYS_[_a-z]\w+ | FD_SETSIZE | TIME_UTC | CPU_SETSIZE | SEM_FAILED | STD(ERR|IN|OUT)_FILENO
    | [FRWX]_OK | F_(U|T)?LOCK | F_TEST | L_(INCR|SET|XTND)
    | W(CONTINUED|EXITED|NOHANG|NOWAIT|STOPPED|UNTRACED)
    """,
    re.VERBOSE,
)

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
        if not _NAME.fullmatch(given) or is_reserved(given) or given in _TAKEN_IN_HEADERS:
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
        if not _NAME.fullmatch(name) or is_reserved(name) or name == "Eigen":
            what = "a name that is taken" if _NAME.fullmatch(name) else "not a valid name"
            raise UnusableNameError(f"--namespace: '{name}' is {what} in C++")
    if "iit" in given.split("::")[1:] or given in ("iit", "iit::rbd", "std"):
        raise UnusableNameError(f"--namespace: '{given}' would hide names of the headers 'iit/rbd'")
    return given


def is_reserved(name: str) -> bool:
    """Return whether a language reserves a name, or a header has a macro of this name."""
    return name in RESERVED or bool(name[-1:] != "_" and _MACRO.fullmatch(name))


def whole_name(name: str) -> str:
    """Return the nearest name that a library may have, which is its namespace's and header's."""
    safe = identifier(name)
    return f"{safe}_" if safe in _TAKEN_IN_HEADERS else safe


def identifier(name: str) -> str:
    """Return the nearest name that all languages take."""
    safe = _UNSAFE.sub("_", name).strip("_") or "x"
    if safe[0].isdigit():
        safe = f"x{safe}"
    return f"{safe}_" if is_reserved(safe) else safe


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
