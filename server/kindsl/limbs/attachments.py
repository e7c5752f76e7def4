"""What names tell of who carries whom: limbs on another limb's body, exchanged joints."""

from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

from kindsl.limbs.names import label_of

_MOST_CROSSED = 2

_Side = tuple[str, str]
_Sided = Mapping[str, _Side]


class Attachment(NamedTuple):
    """The names of a link, of what carries it, and of the joint between them."""

    link: str
    parent: str
    joint: str


class Misplaced(NamedTuple):
    """A link that is not attached as its twins are.

    Attributes:
        attachment: Its names.
        meant: The name of the parent, or of the joint, that its twins let expect, if there is one.
        twins: The attachments of its twins.
    """

    attachment: Attachment
    meant: str | None
    twins: tuple[Attachment, ...]


class _View(NamedTuple):
    """What carries a link, as its twins see it: its words, and whether it is of the same side."""

    words: tuple[str, ...]
    side: str


class LimbNames:
    """The names of a robot's links and joints, and what they tell.

    Attributes:
        twins: Attachments by side and row, of each part that has several.
    """

    def __init__(self, attachments: Sequence[Attachment]) -> None:
        self._limb_words = _words_of_numbered(attachments)
        links = [a.parent for a in attachments] + [a.link for a in attachments]
        self._links = self._sided(dict.fromkeys(links))
        self._joints = self._sided(a.joint for a in attachments)
        by_part: dict[tuple[str, ...], dict[_Side, list[Attachment]]] = {}
        for attachment in attachments:
            label, words = self._read(attachment.link)
            if any(label):
                by_part.setdefault(words, {}).setdefault(label, []).append(attachment)
        self.twins = [
            {label: found[0] for label, found in by_label.items()}
            for by_label in by_part.values()
            if len(by_label) > 1 and all(len(found) == 1 for found in by_label.values())
        ]

    def elsewhere(self) -> list[Misplaced]:
        """Return the links that another body carries than their twins let expect."""
        return self._misplaced(self._links, "parent")

    def crossed(self) -> list[Misplaced]:
        """Return the links whose joint is another than their twins let expect."""
        return self._misplaced(self._joints, "joint")

    def _misplaced(self, sided: _Sided, what: str) -> list[Misplaced]:
        """Return what is not attached as its twins; nothing where that is not a slip or two."""
        across: list[Misplaced] = []
        odd: list[tuple[set[_View], list[Misplaced]]] = []
        for twins in self.twins:
            views = {a: self._view(a, getattr(a, what), sided) for a in twins.values()}
            count = Counter(views.values())
            crossed = [a for a, view in views.items() if view.side == "other"]
            accused = crossed or [a for a, view in views.items() if count[view] == 1]
            is_odd = len(count) == 2 and self._is_odd(len(accused), twins.values(), what)
            if len(crossed) > _MOST_CROSSED or (not crossed and len(count) > 1 and not is_odd):
                return []
            found = [self._judged(a, views, accused, sided) for a in accused]
            if crossed:
                across += found
            elif is_odd:
                odd.append((set(count), found))
        if across:
            return across if not odd and len(across) <= _MOST_CROSSED else []
        is_exchanged = what == "joint" and len(odd) == 2 and odd[0][0] == odd[1][0]
        is_alone = len(odd) == 1 and (what == "parent" or len(odd[0][1]) == 1)
        found = [each for _, found in odd for each in found]
        if is_exchanged:
            return found
        return _placed(found) if is_alone else []

    def _is_odd(self, n_odd: int, twins: Collection[Attachment], what: str) -> bool:
        """Return whether one of several differs, or names can tell that two do."""
        if len(twins) > 2:
            return n_odd == 1
        if what == "parent":
            return any(a.parent in self._links for a in twins)
        return all(a.joint in self._joints for a in twins)

    def _judged(
        self,
        accused: Attachment,
        views: Mapping[Attachment, _View],
        among: Sequence[Attachment],
        sided: _Sided,
    ) -> Misplaced:
        twins = tuple(a for a in views if a not in among)
        expected = {views[a] for a in twins}
        meant = None
        if len(expected) == 1:
            words, side = expected.pop()
            label = self._read(accused.link)[0]
            alike = (n for n, own in sided.items() if own == label and self._read(n)[1] == words)
            meant = words[0] if side == "none" else next(alike, None)
        return Misplaced(accused, meant, twins)

    def _read(self, name: str) -> tuple[_Side, tuple[str, ...]]:
        """Return side and row, or for them the number of a limb, and the other words."""
        side, row, words = label_of(name)
        for index, word in enumerate(words[1:] if not (side or row) else (), 1):
            if word.isdigit() and words[index - 1] in self._limb_words:
                return (word, ""), words[:index] + words[index + 1 :]
        return (side, row), words

    def _sided(self, names: Iterable[str]) -> _Sided:
        """Return side and row of the names that have a twin: `torso_l3` has none."""
        found: dict[tuple[str, ...], list[tuple[str, _Side]]] = {}
        for name in names:
            label, words = self._read(name)
            found.setdefault(words, []).append((name, label))
        groups = (group for group in found.values() if len(group) > 1)
        return {name: label for group in groups for name, label in group if any(label)}

    def _view(self, attachment: Attachment, name: str, sided: _Sided) -> _View:
        label = sided.get(name)
        if label is None:
            return _View((name,), "none")
        mine = self._links.get(attachment.link, ("", ""))
        is_same = all(x == y or not x or not y for x, y in zip(mine, label, strict=True))
        return _View(self._read(name)[1], "same" if is_same else "other")


def _placed(found: list[Misplaced]) -> list[Misplaced]:
    """Return what has a place elsewhere; a part that is only named otherwise has none."""
    return found if all(each.meant is not None for each in found) else []


def _words_of_numbered(attachments: Iterable[Attachment]) -> set[str]:
    """Return the words before the numbers of three or more limbs: `leg` of `leg3_coxa`."""
    heads: dict[tuple[str, tuple[str, ...]], dict[tuple[str, ...], set[str]]] = {}
    for link, parent, _ in attachments:
        side, row, words = label_of(link)
        numbers = tuple(word for word in words if word.isdigit())
        if numbers and not (side or row):
            kept = tuple(word for word in words if not word.isdigit())
            before = {w for w, number in pairwise(words) if number.isdigit()}
            heads.setdefault((parent, kept), {})[numbers] = before
    return {
        word
        for by_number in heads.values()
        if len(by_number) > 2
        for word in set.intersection(*by_number.values())
    }
