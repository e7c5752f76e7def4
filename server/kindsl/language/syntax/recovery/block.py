"""One block, read along the automaton; where a token does not fit, repairs make it go on.

A keyword, or a word that begins with one, is first tried as robcogen2 reads it. Then a least-cost
repair is searched; it becomes one problem. What lacks at the end is supplied.
"""

from collections.abc import Sequence

from kindsl.language.syntax.automaton import Stack, initial, is_complete
from kindsl.language.syntax.builder import build
from kindsl.language.syntax.indentation import lost_closing
from kindsl.language.syntax.recovery.block_kinds import LONGEST_FIRST, Opening, opening, unglued
from kindsl.language.syntax.recovery.lost_heads import lost_head
from kindsl.language.syntax.recovery.messages import closing_problem, repair_problem
from kindsl.language.syntax.recovery.prices import Prices, moments_around
from kindsl.language.syntax.recovery.progress import RepairProgress
from kindsl.language.syntax.recovery.repair import RepairStep, Search, completion
from kindsl.language.syntax.recovery.repair_words import fitting_words, is_alike, repair_words
from kindsl.language.syntax.tables import KEYWORDS
from kindsl.language.syntax.token_names import BLOCK_STARTS, SPELLINGS, supplied
from kindsl.language.syntax.tree import Token

_BACK = 4
_GOES_ON = 3
_GLUED = (*LONGEST_FIRST, "via")


class BlockProgress:
    """The progress of reading a block."""

    def __init__(self, island: RepairProgress, start: str) -> None:
        self.island = island
        self.start = start
        self.stack = initial(start)
        self.read_tokens: list[Token] = []
        self.history: list[Stack] = []

    def read(self) -> None:
        """Read to the end of the block or of the island; add the block's node."""
        island = self.island
        while island.index < len(island.tokens):
            island.lost = self._lost_head()
            if island.lost is not None:
                break
            if self._shift() or self._shift_dialect():
                continue
            if is_complete(self.stack, self.start) and self._is_at_end():
                break
            if island.is_hopeless or not self._mend():
                island.skip_rest()
        if not is_complete(self.stack, self.start):
            kinds = completion(self.stack, self.start)
            place = self._closing_place() if kinds == ["}"] else len(self.read_tokens)
            if island.lost is None:
                self._report_end(kinds, place)
            self._close(kinds, place)
        node = build(self.read_tokens, self.start).node
        if node is None:
            island.skipped += self.read_tokens
        else:
            island.nodes.append(node)

    def _lost_head(self) -> Opening | None:
        """Return the opening of a block whose head is lost together with the end of this one."""
        island = self.island
        is_closed = is_complete(self.stack, self.start)
        start = "" if is_closed else self.start
        lost = lost_head(start, self.read_tokens, island.tokens, island.index)
        return None if lost is not None and len(lost.replaces) > 1 and is_closed else lost

    def _is_at_end(self) -> bool:
        """Return whether another block begins, or a word that may become one stands alone."""
        tokens, index = self.island.tokens, self.island.index
        if opening(tokens, index) is not None:
            return True
        behind = tokens[index + 1].kind if index + 1 < len(tokens) else "}"
        is_word = tokens[index].kind == "NAME" and behind in BLOCK_STARTS
        return is_word and "\n" in self.island.text[self._end() : tokens[index].start]

    def _shift(self) -> bool:
        token = self.island.tokens[self.island.index]
        after = self.stack.after(token.kind)
        if after is None:
            return False
        self._take(token, after)
        self.island.index += 1
        return True

    def _take(self, token: Token, after: Stack) -> None:
        self.history.append(self.stack)
        self.stack = after
        self.read_tokens.append(token)
        self.island.written.append(token)

    def _shift_dialect(self) -> bool:
        """Read on as robcogen2 does: a keyword as a name, or glued to the name behind it."""
        tokens, index = self.island.tokens, self.island.index
        token = tokens[index]
        behind = tokens[index + 1 : index + 1 + _GOES_ON]
        if token.text in KEYWORDS and token.kind != "KEYWORD_NAME":
            after = self.stack.after("KEYWORD_NAME")
            if after is None or not goes_on(after, behind):
                return False
            token.kind = "KEYWORD_NAME"
            return self._shift()
        for keyword, name in unglued(token, _GLUED):
            after = self.stack.after(keyword.kind)
            if after is not None:
                if not goes_on(after, [name, *behind]):
                    return False
                tokens[index : index + 1] = keyword, name
                return self._shift()
        return False

    def _mend(self) -> bool:
        """Find a repair and apply it; return whether there was one."""
        island = self.island
        stacks = [self.stack, *self.history[: -_BACK - 1 : -1]]
        prices = Prices(self.read_tokens, island.tokens, island.index)
        found = Search(island.tokens, island.index, self.start, prices).best(stacks)
        if found is None:
            return self._skip_to_fit()
        self._apply(*found)
        return True

    def _apply(self, first: int, changes: Sequence[RepairStep]) -> None:
        island = self.island
        present = moments_around(self.read_tokens, island.tokens, island.index)
        words = repair_words(changes, island.tokens, present)
        self._unread(first)
        read = len(self.read_tokens)
        wanted: tuple[str, ...] = ()
        for number, (change, word) in enumerate(zip(changes, words, strict=True)):
            while island.index < change.at:
                self._shift()
            if number == 0:
                read, wanted = len(self.read_tokens), fitting_words(self.stack)
            self._change(change, word.text)
        before = self.read_tokens[:read]
        problem = repair_problem(island.text, before, island.tokens, changes, words, wanted)
        is_leftover = all(change.action == "delete" for change in changes)
        (island.leftovers if is_leftover else island.problems).append(problem)
        self.history.clear()

    def _unread(self, index: int) -> None:
        count = self.island.index - index
        if count > 0:
            self.stack = self.history[-count]
            del self.history[-count:]
            del self.read_tokens[-count:]
            del self.island.written[-count:]
            self.island.index = index

    def _change(self, change: RepairStep, word: str) -> None:
        island = self.island
        token = island.tokens[change.at] if change.action != "insert" else None
        if token is not None:
            island.index += 1
        if change.action == "delete":
            island.skip([island.tokens[change.at]])
            return
        after = self.stack.after(change.kind)
        assert after is not None
        new = self._new_token(change.kind, token, word)
        if token is not None and new.start == new.end:
            island.skip([token])
        self._take(new, after)

    def _new_token(self, kind: str, token: Token | None, word: str) -> Token:
        if token is None or not is_alike(token, kind):
            end = token.end if token is not None else self._end()
            return supplied(kind, end, word)
        text = word if kind in SPELLINGS else token.text
        return Token(kind, text, token.lead, token.start, token.end)

    def _end(self) -> int:
        return self.island.written[-1].end if self.island.written else 0

    def _skip_to_fit(self) -> bool:
        """Leave out tokens up to one that fits; return whether one did."""
        island = self.island
        for index in range(island.index + 1, len(island.tokens)):
            after = self.stack.after(island.tokens[index].kind)
            if after is not None and goes_on(after, island.tokens[index + 1 : index + 3]):
                island.skip_to(index)
                self.history.clear()
                return True
        return False

    def _report_end(self, kinds: Sequence[str] | None, place: int) -> None:
        """Report what is missing at the end, unless an unclosed comment hides it."""
        island = self.island
        if not island.is_cut and not island.is_hopeless and kinds != []:
            island.problems.append(
                closing_problem(island.text, self.read_tokens, kinds or ["}"], place)
            )

    def _close(self, kinds: Sequence[str] | None, place: int) -> None:
        island = self.island
        if place < len(self.read_tokens):
            token = supplied("}", self.read_tokens[place - 1].end)
            at = island.written.index(self.read_tokens[place - 1])
            island.written.insert(at + 1, token)
            self.read_tokens.insert(place, token)
            return
        for kind in kinds or []:
            token = supplied(kind, self._end())
            self.read_tokens.append(token)
            island.written.append(token)

    def _closing_place(self) -> int:
        place = lost_closing(self.island.text, self.read_tokens)
        if place is None or place == 0:
            return len(self.read_tokens)
        trial = [*self.read_tokens]
        trial.insert(place, supplied("}", self.read_tokens[place - 1].end))
        is_whole = build(trial, self.start).read == len(trial)
        return place if is_whole else len(self.read_tokens)


def goes_on(stack: Stack, tokens: Sequence[Token]) -> bool:
    """Return whether tokens fit, a keyword also where a name is."""
    following: Stack | None = stack
    for token in tokens:
        assert following is not None
        after = following.after(token.kind)
        if after is None and token.text in KEYWORDS:
            after = following.after("KEYWORD_NAME")
        if after is None:
            return False
        following = after
    return True
