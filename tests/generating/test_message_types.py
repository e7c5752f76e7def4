"""The page's types say what the scene's messages say."""

import dataclasses
import inspect
from collections.abc import Mapping
from typing import Annotated, ClassVar, Literal, get_args, get_origin, get_type_hints

import pytest

from generating import message_types
from kindsl.frontends.preview import requests
from kindsl.mechanics.rigid.pose import Vector3
from kindsl.robots.scene import messages
from kindsl.robots.scene.messages import Metres
from kindsl.robots.scene.size import Segment

KINDS = (
    *get_args(messages.Part), messages.Core, messages.Handle, messages.DifferenceRow, Segment,
    messages.Change, *get_args(requests.Request),
)  # fmt: skip


def test_the_file_is_as_the_messages_want_it(monkeypatch, tmp_path, capsys):
    assert message_types.main(["--check"]) == 0
    monkeypatch.setattr(message_types, "TARGET", tmp_path / "messages.d.ts")
    assert message_types.main(["--check"]) == 1
    assert "out of date" in capsys.readouterr().out
    assert message_types.main([]) == 0
    assert message_types.main(["--check"]) == 0


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_each_number_of_a_message_has_a_unit(kind):
    assert (inspect.getdoc(kind) or "").partition("\n")[0].endswith(".")
    for name, hint in get_type_hints(kind, include_extras=True).items():
        if hint in (float, Vector3) or float in get_args(hint):
            assert get_origin(hint) is Annotated, f"{kind.__name__}.{name}"


def test_no_two_messages_have_one_type():
    kinds = [kind.type for kind in (*get_args(messages.Part), messages.Change)]
    assert len(kinds) == len(set(kinds))


def test_all_that_a_message_can_hold_has_a_type():
    @dataclasses.dataclass(frozen=True)
    class Made:
        """What is made up."""

        type: ClassVar[Literal["made"]] = "made"
        name: str
        size: Annotated[float | None, "metres"]
        pair: Annotated[tuple[float, bool], "a place"]
        rows: tuple[tuple[str, int], ...]
        words: tuple[Literal["a", "b"], ...]
        counts: Annotated[Mapping[str, Metres], "by name"]
        far: Annotated[Metres, "largest of them"]

    assert (
        message_types.interface(Made)
        == """
/** What is made up. */
export interface Made {
  readonly type: "made";
  readonly name: string;
  /** Metres. */
  readonly size: number | null;
  /** A place. */
  readonly pair: readonly [number, boolean];
  readonly rows: readonly (readonly [string, number])[];
  readonly words: readonly ("a" | "b")[];
  /** By name. */
  readonly counts: { readonly [name: string]: number };
  /** Largest of them, metres. */
  readonly far: number;
}
"""
    )


def test_what_a_page_may_leave_out_is_optional():
    text = message_types.interface(requests.Plan)
    assert '  readonly type: "plan";\n' in text
    assert "  readonly revision: number;\n" in text and "  readonly name?: string;\n" in text


def test_what_no_page_could_read_is_refused():
    @dataclasses.dataclass(frozen=True)
    class Made:
        """What is made up."""

        names: set[str]

    with pytest.raises(TypeError, match="a message cannot hold"):
        message_types.interface(Made)
