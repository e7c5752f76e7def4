"""The page's types say what the scene's messages say."""

import dataclasses
from collections.abc import Mapping
from typing import ClassVar, Literal, get_args

import pytest

from kindsl.frontends.preview import message_types
from kindsl.robots.scene import messages


def test_the_file_is_as_the_messages_want_it(monkeypatch, tmp_path, capsys):
    assert message_types.main(["--check"]) == 0
    monkeypatch.setattr(message_types, "TARGET", tmp_path / "messages.d.ts")
    assert message_types.main(["--check"]) == 1
    assert "out of date" in capsys.readouterr().out
    assert message_types.main([]) == 0
    assert message_types.main(["--check"]) == 0


@pytest.mark.parametrize(
    "kind",
    (*get_args(messages.Part), messages.HandleRow, messages.Change),
    ids=lambda k: k.__name__,
)
def test_each_field_of_a_message_is_described(kind):
    first, lines = message_types.described(kind)
    assert first.endswith(".")
    assert list(lines) == [field.name for field in dataclasses.fields(kind)]
    assert all(line.endswith(".") for line in lines.values())


def test_no_two_messages_have_one_type():
    kinds = [kind.type for kind in (*get_args(messages.Part), messages.Change)]
    assert len(kinds) == len(set(kinds))


def test_all_that_a_message_can_hold_has_a_type():
    @dataclasses.dataclass(frozen=True)
    class Made:
        """What is made up.

        Attributes:
            name: A name that is
                told on two lines.
            size: A number or none.
            pair: A place.
            rows: Rows of pairs.
            words: One of two words, several times.
            counts: By name.
        """

        type: ClassVar[Literal["made"]] = "made"
        name: str
        size: float | None
        pair: tuple[float, bool]
        rows: tuple[tuple[str, int], ...]
        words: tuple[Literal["a", "b"], ...]
        counts: Mapping[str, int]

    assert (
        message_types._interface(Made)
        == """
/** What is made up. */
export interface Made {
  readonly type: "made";
  /** A name that is told on two lines. */
  readonly name: string;
  /** A number or none. */
  readonly size: number | null;
  /** A place. */
  readonly pair: readonly [number, boolean];
  /** Rows of pairs. */
  readonly rows: readonly (readonly [string, number])[];
  /** One of two words, several times. */
  readonly words: readonly ("a" | "b")[];
  /** By name. */
  readonly counts: { readonly [name: string]: number };
}
"""
    )


def test_what_no_page_could_read_is_refused():
    @dataclasses.dataclass(frozen=True)
    class Made:
        """What is made up.

        Attributes:
            names: In no order.
        """

        names: set[str]

    with pytest.raises(TypeError, match="a message cannot hold"):
        message_types._interface(Made)
