"""Patterns match what git's do, in time that grows with their length and not faster."""

import re

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from pathspec import GitIgnoreSpec

from kindsl.judgement.config.patterns import can_match, is_match, linear, spec_of

NAMES = st.text("ab.", min_size=1, max_size=6)
PATHS = st.lists(NAMES, min_size=1, max_size=6).map("/".join)
PIECES = st.sampled_from(("a", "b", ".", "*", "?", "[ab]", "[!.]", "**", "/", "/**/", "*a", "\\b"))
PATTERNS = st.lists(PIECES, min_size=1, max_size=12).map("".join)
LINES = st.lists(st.tuples(st.sampled_from(("", "!", "/")), PATTERNS).map("".join), max_size=4)

# Folders for which all numbers may be tried.
ANY_FOLDERS = re.compile(r"(?<!\(\?>)\(\?:/?\.\+\??/?\)\?")

# Patterns that Python's expressions try in more ways than there are atoms, and paths for them.
HOSTILE = [
    ("*a" * 40 + "x", "a" * 250),
    ("?*" * 100 + "x", "a" * 250),
    ("*[a-b]" * 40 + "[!a]x", "ab" * 125),
    ("**/a/" * 40 + "x", "a/" * 500 + "a"),
    ("a/" + "**/*a*a/" * 30 + "*a*a*a*x", "aaaa/" * 200 + "a"),
    ("*" * 60 + "x", "a" * 250),
    ("*" * 60 + "/" + "*a" * 30 + "/**", "a" * 250 + "/" + "a" * 250),
]


@given(LINES, PATHS)
@example(["a*[!.]*b"], "a.b/b")
@example(["**/a/**/b"], "a/a/b")
@example(["**/a*b/*b/**/b"], "ab/aab/bb/a/b")
def test_patterns_match_what_those_of_the_library_do(lines: list[str], path: str) -> None:
    # The library lets `[!x]` match a slash, which git does not.
    lines = [line.replace("[!.]", "[ab]") for line in lines]
    try:
        expected = GitIgnoreSpec.from_lines(lines)
    except ValueError:
        with pytest.raises(ValueError, match="pattern"):
            spec_of(lines)
        return
    for name in (path, f"{path}/"):
        assert spec_of(lines).check_file(name).include == expected.check_file(name).include


@pytest.mark.parametrize(
    ("pattern", "path"), [("arms/a[!b]c", "arms/a/c"), ("a*[!b]c", "aa/c"), ("a[+-9]c", "a/c")]
)
def test_a_class_is_no_slash_as_in_git(pattern: str, path: str) -> None:
    assert not is_match("kindsl.toml", pattern, path)


@pytest.mark.parametrize(("pattern", "path"), HOSTILE)
def test_no_pattern_keeps_anybody_waiting(pattern: str, path: str) -> None:
    # Without a bound on the ways that are tried, none of these would ever end.
    assert not is_match("kindsl.toml", pattern, path)
    assert spec_of([pattern]).check_file(path).include is None


@given(PATTERNS)
@example("a/**/b/**/c")
@example("**/a/**/b/**/c")
def test_no_place_is_tried_twice(pattern: str) -> None:
    try:
        parts = spec_of([pattern]).patterns
    except ValueError:
        return
    for part in parts:
        expression = part.regex.pattern if part.regex is not None else ""
        for name in expression.split("/"):
            after_groups = name.rpartition("(?>")[2]
            assert after_groups.count("[^/]*") - after_groups.count("[^/]*?") <= 1
        assert len(ANY_FOLDERS.findall(expression)) <= 1, expression


@pytest.mark.parametrize("pattern", ["[[a]b", "[a&&b]", "[a||b]", "[a~~b]"])
def test_what_means_more_to_python_means_itself(pattern: str) -> None:
    assert can_match(pattern)
    assert not is_match("kindsl.toml", pattern, "none")


def test_a_short_pattern_stays_as_it_is() -> None:
    assert linear("^(?:.+/)?arm[^/]*\\.kindsl(?:(?P<ps_d>/)|$)").count("(?>") == 0
