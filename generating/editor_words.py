"""The words of the language where editors list them: each list is replaced in its file."""

import re
from collections.abc import Iterator, Mapping, Sequence
from textwrap import wrap
from typing import Any, NamedTuple


class _List(NamedTuple):
    """A list of words in a file.

    Attributes:
        file: Its path in the repository.
        pattern: What it stands in, the list as the one group.
        words: The name of the words that belong there.
        form: How a word is written.
        between: What separates words.
    """

    file: str
    pattern: str
    words: str
    form: str = "{}"
    between: str = "|"


_VIM, _EMACS = "editors/vim/syntax/kindsl.vim", "editors/emacs/kindsl-mode.el"
_TEXTMATE = "grammar/kindsl.tmLanguage.json"
_QUOTED = ('"{}"', " ")
_LISTS = (
    *(
        _List(_VIM, rf"syntax keyword kindsl{name} (.*)", words, between=" ")
        for name, words in (
            ("Block", "blocks"),
            ("Section", "sections"),
            ("Word", "others"),
            ("Constant", "constants"),
        )
    ),
    _List(_VIM, r"kindslName /\\%\(\\<\\%\((.*?)\\\)\\s", "blocks", between="\\|"),
    _List("editors/vim/autoload/kindsl.vim", r"\^\\s\*\\%\((R.*?)\\\)", "flush", between="\\|"),
    _List("editors/vim/indent/kindsl.vim", r"indentkeys=0},!\^F,o,O,(.*)", "flush", "={}", ","),
    _List(_EMACS, r"kindsl--blocks '\((.*?)\)", "blocks", *_QUOTED),
    _List(_EMACS, r"kindsl--sections\s+'\(([^)]*)\)", "inner", *_QUOTED),
    _List(_EMACS, r"kindsl--constants '\((.*?)\)", "constants", *_QUOTED),
    _List(_TEXTMATE, r'"storage.type.kindsl",\s+"match": "\\\\b\(\?:(.*?)\)', "blocks"),
    _List(_TEXTMATE, r'"storage.type.section.kindsl",\s+"match": "\\\\b\(\?:(.*?)\)', "braced"),
    _List(_TEXTMATE, r'"storage.type.property.kindsl",\s+"match": "\\\\b\(\?:(.*?)\)', "valued"),
    _List("grammar/language-configuration.json", r"\(\?:\\\\}\|\(\?:(.*?)\)", "flush"),
    _List(
        "web/src/playground/language.js",
        r"const KEYWORDS = \[\n  ([^\]]*?),\n\]",
        "all",
        '"{}"',
        ", ",
    ),
)


def editor_files(tables: Mapping[str, Any], texts: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """Yield the files that list words, with the words of the grammar in their place.

    Args:
        tables: The tables of the grammar by name.
        texts: The files as they are, by path in the repository.
    """
    words = _words(tables)
    for file, text in texts.items():
        for each in _LISTS:
            if each.file == file:
                (match,) = re.finditer(each.pattern, text)
                new = each.between.join(each.form.format(word) for word in words[each.words])
                if '"' in each.form:
                    margin = match.start(1) - text.rfind("\n", 0, match.start(1)) - 1
                    new = "\n".join(wrap(new, 96 - margin)).replace("\n", "\n" + margin * " ")
                text = text[: match.start(1)] + new + text[match.end(1) :]
        yield file, text


FILES = tuple(dict.fromkeys(each.file for each in _LISTS))


def _words(tables: Mapping[str, Any]) -> dict[str, Sequence[str]]:
    keywords, kinds, holds = tables["KEYWORDS"], tables["KINDS"], tables["HOLDS"]

    def begun_by(constructs: Sequence[str]) -> list[str]:
        found = (word for name in constructs for word in tables["WORDS"][name])
        return list(dict.fromkeys(word for word in found if word in keywords))

    top = holds["document"]
    within = [part for name, parts in holds.items() if name != "document" for part in parts]
    blocks, sections = begun_by(top), begun_by(within)
    braced = begun_by([s for s in within if kinds[s] in ("block", "pose", "list", "groups")])
    constants = [word for word, kind in keywords.items() if kind in tables["CLASSES"]["_pi"]]
    others = [w for w in keywords if w not in {*blocks, *sections, *constants}]
    return {
        "blocks": blocks,
        "flush": blocks[1:],
        "sections": sections,
        "braced": braced,
        "valued": [word for word in sections if word not in braced],
        "others": others,
        "inner": [*sections, *others],
        "constants": constants,
        "all": [*blocks, *sections, *others],
    }
