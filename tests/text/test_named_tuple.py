"""Our `NamedTuple` is as good as the one of `typing`."""

import copy
import pickle
from typing import Any, NamedTuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kindsl.text.named_tuple import NamedTuple as OurTuple


class Theirs(NamedTuple):
    a: int
    b: str = "x"
    c: tuple[int, ...] = ()


class Ours(OurTuple):
    """Three things."""

    a: int
    b: str = "x"
    c: tuple[int, ...] = ()

    @property
    def doubled(self) -> int:
        return 2 * self.a

    @classmethod
    def of(cls, text: str) -> "Ours":
        return cls(len(text), text)


class Derived(Ours):
    def __str__(self) -> str:
        return self.b


NAMES = st.dictionaries(st.sampled_from(["a", "b", "c", "d"]), st.integers(), max_size=4)


@given(st.lists(st.integers(), max_size=4), NAMES)
def test_takes_what_theirs_takes_and_is_equal(values: list[Any], named: dict[str, Any]) -> None:
    try:
        theirs = Theirs(*values, **named)
    except TypeError:
        with pytest.raises(TypeError, match=r"^Ours"):
            Ours(*values, **named)
        return
    ours = Ours(*values, **named)
    assert ours == theirs
    assert hash(ours) == hash(theirs)
    assert repr(ours) == repr(theirs).replace("Theirs", "Ours")
    assert (ours.a, ours.b, ours.c) == tuple(theirs)
    assert ours._asdict() == theirs._asdict()
    assert ours._replace(a=7) == theirs._replace(a=7)
    assert pickle.loads(pickle.dumps(ours)) == ours
    assert type(pickle.loads(pickle.dumps(ours))) is Ours
    assert copy.deepcopy(ours) == ours


def test_is_a_class_as_others() -> None:
    assert Ours.of("abc").doubled == 6
    assert Ours._fields == Theirs._fields == Ours.__match_args__
    assert Ours.__doc__ == "Three things."
    assert sorted([Ours(2), Ours(1)]) == [(1, "x", ()), (2, "x", ())]
    with pytest.raises(AttributeError):
        Ours(1).a = 2  # type: ignore[misc]
    with pytest.raises(AttributeError):
        Ours(1).d = 2  # type: ignore[attr-defined]
    match Ours(1, "y"):
        case Ours(1, b):
            assert b == "y"
    with pytest.raises(TypeError):
        Ours(1)._replace(d=1)


def test_can_be_derived_from() -> None:
    assert str(Derived(1, "z")) == "z"
    assert Derived(1) == Ours(1)
    assert pickle.loads(pickle.dumps(Derived(1))) == Derived(1)
