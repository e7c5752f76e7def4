"""The lossless syntax tree: islands of text, their tokens and nodes.

A document is a row of islands, each a piece of text that the parser reads by itself: the head,
the base, a link, a joint. All offsets inside an island count from the island's start, so that an
edit elsewhere leaves it as it is.

Conventions of the nodes, whose kinds are the rules and aliases of `grammar/kindsl.lark`:

- All tokens are there, keywords and signs too; a name is a token of the kind `NAME`, however it
  is spelt (`pi`, `^x`, a keyword), directly in its block: `link` has the children
  `link NAME { id inertia children frames }`.
- Repaired text has the same shape: a supplied token is empty (`is_missing`); a misspelt keyword
  has the proper keyword as its text and the span of the written word.
- A `vector` always has three components; an expression too long for any generator is one flat
  node `unsupported`.
- `text[token.lead:token.end]` of all tokens, and what is behind the last one, are the island.
"""

from collections.abc import Iterator
from typing import NamedTuple

from kindsl.language.text.facts import Facts


class Token:
    """A word, number or sign. Blanks and comments lie between tokens, in `lead`.

    Attributes:
        kind: The terminal's name in the grammar; keywords and signs by their own text.
        text: As written; what was expected, for a missing token.
        lead: Where the blanks, comments and skipped text before it begin.
        start: Where it begins, code points from the island's start.
        end: Where it ends; equal to `start` for a missing token.
    """

    __slots__ = ("end", "kind", "lead", "start", "text")

    def __init__(self, kind: str, text: str, lead: int, start: int, end: int) -> None:
        self.kind = kind
        self.text = text
        self.lead = lead
        self.start = start
        self.end = end

    @property
    def is_missing(self) -> bool:
        """True if the parser supplied it."""
        return self.start == self.end

    def __repr__(self) -> str:
        return f"Token({self.kind}, {self.text!r}, {self.start}..{self.end})"


class Node:
    """A construct of the grammar with all its tokens.

    Attributes:
        kind: The rule's name (or alias) in the grammar.
        children: Nodes and tokens in the order of the text.
    """

    __slots__ = ("children", "kind")

    def __init__(self, kind: str, children: "list[Node | Token]") -> None:
        self.kind = kind
        self.children = children

    @property
    def start(self) -> int:
        """The start of its first token."""
        child = self.children[0]
        while isinstance(child, Node):
            child = child.children[0]
        return child.start

    @property
    def end(self) -> int:
        """The end of its last token."""
        child = self.children[-1]
        while isinstance(child, Node):
            child = child.children[-1]
        return child.end

    def nodes(self, kind: str) -> "Iterator[Node]":
        """Yield the children that are nodes of that kind."""
        for child in self.children:
            if child.kind == kind and isinstance(child, Node):
                yield child

    @property
    def parts(self) -> "list[Node]":
        """The children that are nodes."""
        return [child for child in self.children if isinstance(child, Node)]

    def walk(self) -> "Iterator[Node]":
        """Yield the node and all nodes below, each before its own, in order."""
        pending = [self]
        while pending:
            node = pending.pop()
            yield node
            pending += node.parts[::-1]

    def tokens(self) -> Iterator[Token]:
        """Yield all tokens below, in order."""
        pending = self.children[::-1]
        while pending:
            child = pending.pop()
            if isinstance(child, Token):
                yield child
            else:
                pending += child.children[::-1]

    def __repr__(self) -> str:
        return f"Node({self.kind}, {self.children!r})"


class Edit(NamedTuple):
    """A replacement inside one island, offsets from the island's start."""

    start: int
    end: int
    text: str


class Repair(NamedTuple):
    """A change of text that would remove a problem."""

    title: str
    edits: tuple[Edit, ...]
    is_safe: bool


class Problem(NamedTuple):
    """Something that is not in the language.

    Attributes:
        code: The rule it is reported under, `KD001` to `KD011`.
        message: One sentence, no final period.
        repair: The edit that fixes it, where that is known.
        choices: Edits that fix it where two things may be meant; then there is no `repair`.
    """

    code: str
    message: str
    start: int
    end: int
    repair: Repair | None = None
    choices: tuple[Repair, ...] = ()

    def repaired_by(self, repairs: tuple[Repair, ...]) -> "Problem":
        """Return the same with what fixes it: several are choices."""
        if len(repairs) == 1:
            return self._replace(repair=repairs[0])
        return self._replace(choices=repairs)


class Island:
    """A piece of the document that is parsed on its own; immutable.

    Attributes:
        text: The piece as written, with the blanks and comments around it.
        nodes: The blocks found in it, mostly one: `head`, `base`, `link`, `joint`, `end`.
        tokens: All tokens in order, the missing and the skipped ones left out of neither.
        skipped: Tokens that fit nowhere; they are in no node.
        facts: Results that later layers derived from it alone, kept as long as it lives.
    """

    __slots__ = (
        "__weakref__",
        "comments",
        "facts",
        "nodes",
        "problems",
        "skipped",
        "text",
        "tokens",
    )

    def __init__(
        self,
        text: str,
        nodes: tuple[Node, ...],
        tokens: tuple[Token, ...],
        skipped: tuple[Token, ...],
        comments: tuple[tuple[int, int], ...],
        problems: tuple[Problem, ...],
    ) -> None:
        self.text = text
        self.nodes = nodes
        self.tokens = tokens
        self.skipped = skipped
        self.comments = comments
        self.problems = problems
        self.facts = Facts()
