"""Facts are found again by whoever keeps them, and by nobody else."""

from kindsl.language.text.facts import Fact, Facts


def test_each_kind_is_kept_apart() -> None:
    facts, lines, same_name = Facts(), Fact[int]("lines"), Fact[str]("lines")
    assert facts.get(lines) is None
    assert facts.keep(lines, 0) == 0
    assert facts.get(lines) == 0
    assert facts.get(same_name) is None
    assert facts.keep(same_name, "x") == "x"
    assert facts.keep(lines, 4) == 4
    assert (facts.get(lines), facts.get(same_name)) == (4, "x")
    facts.forget(lines)
    facts.forget(lines)
    assert (facts.get(lines), facts.get(same_name)) == (None, "x")
    assert Facts().get(same_name) is None
    assert repr(lines) == "Fact('lines')"
