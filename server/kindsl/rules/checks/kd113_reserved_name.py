"""A name that the generated code has for something else.

## What it does
Reports names that are keywords of C++ or of Octave, and frames called `fr_<link>`, as the
generators call the frame of a link.

## Why is this bad?
The names of links, joints, frames and parameters become identifiers of the generated code, which
then does not compile; and of two frames with one name one is lost.

## Example
```kindsl
link union { id = 1 children {} }
```
"""

from collections.abc import Iterator

from kindsl.rules.base import Finding, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import link
from kindsl.semantics.model import Model
from kindsl.semantics.places import Name

_CPP = """alignas alignof and and_eq asm auto bitand bitor bool break case catch char class compl
    concept const consteval constexpr constinit const_cast continue co_await co_return co_yield
    decltype default delete do double dynamic_cast else enum explicit export extern false float for
    friend goto if inline int long mutable namespace new noexcept not not_eq nullptr operator or
    or_eq private protected public register reinterpret_cast requires return short signed sizeof
    static static_assert static_cast struct switch template this thread_local throw true try
    typedef typeid typename union unsigned using virtual void volatile wchar_t while xor
    xor_eq"""
_OCTAVE = """break case catch continue do else elseif end end_try_catch end_unwind_protect endfor
    endfunction endif endswitch endwhile for function global if otherwise persistent return switch
    try until unwind_protect unwind_protect_cleanup while"""
_LANGUAGES = dict.fromkeys(_OCTAVE.split(), "Octave") | dict.fromkeys(_CPP.split(), "C++")


def check_document(model: Model, _: Context) -> Iterator[Finding]:
    """Yield a finding for each reserved name."""
    for name in _names(model):
        if name in _LANGUAGES:
            yield Finding(name, f"'{name}' is a keyword of {_LANGUAGES[name]}")
    for frame in model.frames:
        if frame.name.startswith("fr_") and frame.name[3:] in model.body_named:
            message = f"the frame of link '{frame.name[3:]}' is called '{frame.name}' already"
            yield Finding(frame.name, message)


def _names(model: Model) -> Iterator[Name | None]:
    yield from (declared.robot for declared in model.declared)
    yield from (body.name for body in model.bodies)
    yield from (joint.name for joint in model.joints)
    yield from (frame.name for frame in model.frames)
    yield from (parameter.name for parameter in model.parameters)


_FRAMED = """link head {
    id = 1
    children {}
    frames { %s { translation = (0.1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}"""

RULE = Rule(
    "KD113",
    "reserved-name",
    Severity.WARNING,
    check_document=check_document,
    good=(link("gripper", 1), _FRAMED % "fr_eye"),
    bad=(link("union", 1), link("until", 1), _FRAMED % "fr_head"),
)
