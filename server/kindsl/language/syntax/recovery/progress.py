"""The progress of reading an island: its tokens so far, and the problems found."""

from collections.abc import Sequence

from kindsl.language.syntax.recovery.block_kinds import Opening
from kindsl.language.syntax.recovery.messages import leftover_problem
from kindsl.language.syntax.token_names import BLOCK_STARTS
from kindsl.language.syntax.tree import Node, Problem, Token

_MOST_PROBLEMS = 12


class RepairProgress:
    """The tokens of an island, and the tree made of them so far.

    Attributes:
        tokens: Its tokens, changed where they are read as others.
        is_cut: Whether a comment without an end hides the rest of it.
        written: All tokens so far, in order: read, supplied and skipped.
        skipped: Those that are in no node.
        problems: One for each repair but those in `leftovers`.
        leftovers: One for each repair that does nothing but leave tokens out.
        lost: The block whose head is lost together with the end of the one before.
    """

    def __init__(self, text: str, tokens: list[Token], is_cut: bool) -> None:
        self.text = text
        self.tokens = tokens
        self.is_cut = is_cut
        self.index = 0
        self.nodes: list[Node] = []
        self.written: list[Token] = []
        self.skipped: list[Token] = []
        self.problems: list[Problem] = []
        self.leftovers: list[Problem] = []
        self.lost: Opening | None = None

    @property
    def is_hopeless(self) -> bool:
        """True if so much is wrong that no more repairs are sought."""
        return len(self.problems) + len(self.leftovers) >= _MOST_PROBLEMS

    def skip(self, tokens: Sequence[Token]) -> None:
        """Leave tokens out."""
        self.skipped += tokens
        self.written += tokens

    def skip_rest(self) -> None:
        """Skip the rest, with one message."""
        self.skip_to(len(self.tokens))

    def skip_to_block(self) -> None:
        """Skip to the next line that begins a block, with one message."""
        for index in range(self.index + 1, len(self.tokens)):
            between = self.text[self.tokens[index - 1].end : self.tokens[index].start]
            if self.tokens[index].kind in BLOCK_STARTS and "\n" in between:
                self.skip_to(index)
                return
        self.skip_rest()

    def skip_to(self, end: int) -> None:
        """Skip to the token `end`, with one message."""
        rest = self.tokens[self.index : end]
        previous = self.nodes[-1].kind if self.nodes else ""
        self.leftovers.append(leftover_problem(self.written, rest, self.text, previous))
        self.skip(rest)
        self.index = end

    def open(self, block: Opening) -> None:
        """Put the block's proper beginning in place of the written one."""
        if block.problem is not None:
            self.problems.append(block.problem)
        self.tokens[self.index : self.index + len(block.replaces)] = block.tokens
