"""Names that tell who carries whom: limbs on another limb's body, exchanged joints."""

from collections import Counter
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import chain, combinations, pairwise
from typing import NamedTuple

from kindsl.robots.limbs.names import label_of, tokens

_MOST_CROSSED, _MOST_ODD, _ENOUGH = 2, 40, 2
# Where two hang on each other nobody can say which of them should not.
_FEWEST_REPLICAS = 3
_SAYING_NOTHING = frozenset(("link", "joint"))
_Side = tuple[str, str]
_Words = tuple[str, ...]
_Sided = Mapping[str, _Side]


class Attachment(NamedTuple):
    """The names of a link, of what carries it, and of the joint between them."""

    link: str
    parent: str
    joint: str


class Misplaced(NamedTuple):
    """A link that is not attached as its peers are, or as other links by their names.

    Attributes:
        attachment: Its names.
        meant: The name of the parent, or of the joint, that is expected, if there is one.
        peers: The attachments of its peers; none where its own name tells.
    """

    attachment: Attachment
    meant: str | None
    peers: tuple[Attachment, ...]


class _View(NamedTuple):
    """The carrier of a link, as its peers see it: its words, and whether it is of the same side."""

    words: _Words
    side: str


class LimbNames:
    """The names of a robot's links and joints, and what they tell."""

    def __init__(self, attachments: Sequence[Attachment], early: Container[str] = ()) -> None:
        """Compare names.

        Args:
            attachments: Of all links but the base.
            early: The links that are numbered before what carries them.
        """
        self._attachments, self._early = attachments, early
        self._limb_words = _words_of_numbered(attachments)
        rows: dict[_Words, set[_Side]] = {}
        for name in chain.from_iterable(attachments):
            side, row, words, _ = label_of(name)
            rows.setdefault(words, set()).add((side, row))
        # `middle` is the part of a finger where there is neither a front nor a rear one.
        self._of_one_row = {words for words, labels in rows.items() if len(labels) == 1}
        serial = self._serial()
        # Of the names on one chain a side or a row says where on it, not of which limb.
        apart = [a for a in attachments if a.link not in serial]
        links = [a.parent for a in attachments if a.parent not in serial]
        links += [a.link for a in apart]
        self._links = self._sided(dict.fromkeys(links))
        self._joints = self._sided(a.joint for a in attachments)
        by_part: dict[_Words, dict[_Side, list[Attachment]]] = {}
        for attachment in apart:
            label, words = self._read(attachment.link)
            if any(label):
                by_part.setdefault(words, {}).setdefault(label, []).append(attachment)
        self._peers = [
            [found[0] for found in by_label.values()]
            for by_label in by_part.values()
            if len(by_label) > 1 and all(len(found) == 1 for found in by_label.values())
        ]

    def _serial(self) -> set[str]:
        """Return the links that carry, or hang on, another link called alike but for its side.

        One of three or more may be misplaced, on a limb of another side: it is none of these.
        """
        parents = {a.link: a.parent for a in self._attachments}
        by_part: dict[_Words, list[str]] = {}
        for name in dict.fromkeys([*parents.values(), *parents]):
            label, words = self._read(name)
            if any(label):
                by_part.setdefault(words, []).append(name)
        serial: set[str] = set()
        for names in by_part.values():
            hanging = [name for name in names if not links_above(name, parents).isdisjoint(names)]
            if len(hanging) > 1 or (hanging and len(names) < _FEWEST_REPLICAS):
                serial.update(names)
        return serial

    @cached_property
    def elsewhere(self) -> list[Misplaced]:
        """The links that another body carries than their peers let expect."""
        return self._misplaced(self._links, "parent")

    @cached_property
    def crossed(self) -> list[Misplaced]:
        """The links whose joint is another than their peers, or names, let expect."""
        found = self._misplaced(self._joints, "joint")
        # Of two sides their names cannot tell which is wrong; how all others are named can.
        are_two_sides = any(one.attachment in other.peers for one in found for other in found)
        return (self._crossed_by_name() if are_two_sides or not found else []) or found

    def _misplaced(self, sided: _Sided, what: str) -> list[Misplaced]:
        """Return what is not attached as its peers; nothing where that is not a slip or two."""
        across: list[Misplaced] = []
        odd: list[tuple[set[_View], list[Misplaced]]] = []
        for peers in self._peers:
            views = {a: self._view(a, getattr(a, what), sided) for a in peers}
            count = Counter(views.values())
            crossed = [a for a, view in views.items() if view.side == "other"]
            accused = crossed or [a for a, view in views.items() if count[view] == 1]
            early = [a for a in accused if what == "parent" and a.link in self._early]
            if len(accused) == len(peers) == 2 and len(early) == 1:
                accused = early
            apart = frozenset(accused)
            others = tuple(a for a in views if a not in apart)
            found = [_of_row(self._judged(a, views, others, sided)) for a in accused]
            if crossed:
                across += found
            elif len(count) > 1:
                is_told = len(found) == 1 or (len(peers) == 2 and _is_sided(peers, what, sided))
                if len(count) > 2 or not is_told:
                    return []
                odd.append((set(count), found))
        if across:
            return across if not odd and len(across) <= _MOST_CROSSED else []
        told = [each for _, group in odd for each in group]
        if what == "joint" and len(odd) == 2 and odd[0][0] == odd[1][0]:
            return [m for _, group in odd for m in self._of_two(group, what, sided) or group]
        if what == "parent" and len(odd) == 1 and len(told) == 2:
            return self._of_two(told, what, sided)
        # A part that is only named otherwise has no place elsewhere.
        is_alone = len(odd) == 1 and (what == "parent" or len(told) == 1)
        return told if is_alone and all(each.meant is not None for each in told) else []

    def _of_two(self, told: Sequence[Misplaced], what: str, sided: _Sided) -> list[Misplaced]:
        """Return a left and a right link, of which either may be misplaced, each with the other.

        Either could hang on, or move by, what that of its peer is on its own side.
        """
        if len(told) != 2:
            return []
        here, there = (each.attachment for each in told)
        found = []
        for own, peer in ((here, there), (there, here)):
            (side, row), (other_side, other_row) = (self._read(a.link)[0] for a in (own, peer))
            is_pair = row == other_row and side and other_side
            of_peer = getattr(peer, what)
            meant = self._counterpart((side, row), of_peer, sided) if is_pair else None
            if meant is None:
                return []
            found.append(Misplaced(own, meant, (peer,)))
        return found

    def _counterpart(self, label: _Side, carrier: str, sided: _Sided) -> str | None:
        """Return what is called like a carrier but of this side, itself if it is of none."""
        of, words = self._read(carrier)
        alike = (n for n, own in sided.items() if own == label and self._read(n)[1] == words)
        return next(alike, None) if any(of) else carrier

    def _judged(
        self,
        accused: Attachment,
        views: Mapping[Attachment, _View],
        peers: tuple[Attachment, ...],
        sided: _Sided,
    ) -> Misplaced:
        """Return an attachment with what its peers, which are not accused, let expect.

        Where all are, each is meant to have of its own side what it has of the other.
        """
        meant, own = None, views[accused]
        seen = {views[a] for a in peers} or ({own} if own.side == "other" else set())
        if len(seen) == 1:
            words, side = seen.pop()
            label = self._read(accused.link)[0]
            alike = (n for n, own in sided.items() if own == label and self._read(n)[1] == words)
            meant = words[0] if side == "none" else next(alike, None)
        return Misplaced(accused, meant, peers)

    def _crossed_by_name(self) -> list[Misplaced]:
        """Return two links that have each other's joints, as the names of all others go."""
        customs = [(a, tuple(_customs(a.link, a.joint))) for a in self._attachments]
        count = Counter(custom for _, each in customs for custom in each)
        usual = {custom for custom, number in count.items() if number >= _ENOUGH}
        odd = [a for a, own in customs if usual.isdisjoint(own)]
        pairs = [
            (one, other)
            for one, other in combinations(odd[:_MOST_ODD] if usual else (), 2)
            if not usual.isdisjoint(_customs(one.link, other.joint))
            and not usual.isdisjoint(_customs(other.link, one.joint))
        ]
        if len(pairs) != 1:
            return []
        one, other = pairs[0]
        return [Misplaced(one, other.joint, ()), Misplaced(other, one.joint, ())]

    def _read(self, name: str) -> tuple[_Side, _Words]:
        """Return side and row, or for them the number of a limb, and the other words."""
        side, row, words, _ = label_of(name)
        if row and not side and words in self._of_one_row:
            row, words = "", tokens(name)
        for index, word in enumerate(words[1:] if not (side or row) else (), 1):
            if word.isdigit() and words[index - 1] in self._limb_words:
                return (word, ""), words[:index] + words[index + 1 :]
        return (side, row), words

    def _sided(self, names: Iterable[str]) -> _Sided:
        """Return side and row of the names that have a peer: `torso_l3` has none."""
        found: dict[_Words, list[tuple[str, _Side]]] = {}
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
        pairs = zip(mine, label, strict=True)
        is_same = all(x == y or not x or not y or x.isdigit() != y.isdigit() for x, y in pairs)
        return _View(self._read(name)[1], "same" if is_same else "other")


def _of_row(told: Misplaced) -> Misplaced:
    """Return the one peer that hangs on a body of another row, where the accused is in its own."""
    (link, parent, _), meant, peers = told
    row = label_of(link).row
    wrong = [each for each in peers if label_of(each.link).row == row]
    is_own = row and label_of(parent).row == row and label_of(meant or "").row not in ("", row)
    return Misplaced(wrong[0], parent, (told.attachment,)) if is_own and len(wrong) == 1 else told


def links_above(name: str, parents: Mapping[str, str]) -> set[str]:
    """Return the names of the links between a link and the base."""
    found: set[str] = set()
    while (name := parents.get(name, "")) and name not in found:
        found.add(name)
    return found


def _is_sided(peers: Sequence[Attachment], what: str, sided: _Sided) -> bool:
    """Return whether names can tell of two peers that one differs."""
    known = [getattr(a, what) in sided for a in peers]
    return any(known) if what == "parent" else all(known)


def _customs(link: str, joint: str) -> Iterator[object]:
    """Yield how a joint is named after its link: with its words, or a number so much higher."""
    here, there = ([w for w in tokens(n) if w not in _SAYING_NOTHING] for n in (link, joint))
    if here == there:
        yield "same"
    numbers = [[int(word) for word in words if word.isdigit()] for words in (here, there)]
    if all(len(each) == 1 for each in numbers):
        words = [tuple(w for w in words if not w.isdigit()) for words in (here, there)]
        yield (*words, numbers[1][0] - numbers[0][0])


def _words_of_numbered(attachments: Sequence[Attachment]) -> set[str]:
    """Return the words before the numbers of three or more limbs: `leg` of `leg3_coxa`.

    Of a limb whose head has a number, what any other name in it has before that number alone too.
    """
    heads: dict[tuple[str, _Words], dict[_Words, tuple[str, set[str]]]] = {}
    for link, parent, _ in attachments:
        side, row, words, part = label_of(link)
        numbers = tuple(word for word in words if word.isdigit())
        if numbers and not (side or row):
            before = {w for w, number in pairwise(words) if number.isdigit()}
            heads.setdefault((parent, part), {})[numbers] = link, before
    many = [by_number for by_number in heads.values() if len(by_number) > 2]
    found = {w for m in many for w in set.intersection(*(before for _, before in m.values()))}
    number_of = {link: n[0] for m in many for n, (link, _) in m.items() if len(n) == 1}
    for link, parent, _ in attachments:
        if link not in number_of and parent in number_of:
            number_of[link] = number_of[parent]
    before_number: dict[str, set[tuple[str, bool]]] = {}
    for link, _, joint in attachments if number_of else ():
        number = number_of.get(link)
        for word, other in pairwise(label_of(joint).words) if number else ():
            if other.isdigit():
                before_number.setdefault(word, set()).add((other, other == number))
    return found | {
        word
        for word, seen in before_number.items()
        if len(seen) > 2 and all(is_own for _, is_own in seen)
    }
