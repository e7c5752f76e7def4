"""Mistakes in copying ten numbers, in one table, and the numbers as they were meant.

A row has its rule and its weight against the others, which `fitted` corrects. Two at a time are
tried as far as `_PAIRS` says, for a share of their weight.
"""

from collections.abc import Callable, Container, Iterator, Sequence
from enum import StrEnum
from functools import partial
from itertools import combinations
from math import exp, log
from operator import mul
from typing import Any, NamedTuple, TypeVar

from kindsl.judgement.diagnosis.fitted import TABLES, WEIGHTS
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.mechanics.rigid.body import ROUNDING_OF_MOMENTS, MassDistribution, Symmetric, shifted
from kindsl.mechanics.rigid.pose import Vector3

_Values = TypeVar("_Values", Symmetric, Vector3)

Kind = tuple[object, ...]

_PRODUCTS = (3, 4, 5)
# What people write moments in: CAD programs in grams or kilograms, finite elements in tonnes,
# nobody in any other power of ten.
_UNITS = (
    (-9, "g·mm²", 1.0),
    (-6, "kg·mm²", 1.0),
    (-7, "g·cm²", 1.0),
    (-4, "kg·cm²", 1.0),
    (-3, "t·mm²", 0.25),
    *((power, "", 2.5e-5) for power in (-1, 1, -2, 2, 3, 4, 6)),
)
# A second slip is looked for beside the units of CAD programs only.
_GREATEST_OF_PAIR = -4
_MASSES = ((-3, "g", 1.0), (-1, "", 0.1), (1, "", 0.1))
_LENGTHS = ((1e-3, "mm", 1.0), (1e-2, "cm", 0.5), (0.0254, "in", 0.1))
_RIVAL = 0.2
_LOG_TEN = log(10.0)
# Where the six moments stand in the rows of half a matrix, as in URDF, and with axes turned round.
_ROWS = (0, 3, 5, 1, 2, 4)
_TURNS = (((1, 2, 0, 5, 3, 4), "y, z and x"), ((2, 0, 1, 4, 5, 3), "z, x and y"))


class Slip(StrEnum):
    """A simple mistake."""

    SIGNS = "signs"
    SIGNS_THERE = "signs about the CoM"
    REFERENCE = "reference"
    TWICE = "shifted twice"
    SCALE = "scale"
    COM_UNIT = "CoM in another unit"
    MOMENT = "power of ten of a moment"
    NUMBER = "one number typed anew"
    MINUS = "sign of a moment"
    COM_SIGN = "sign of the CoM"
    COM_ORDER = "two coordinates of the CoM swapped"
    SWAP = "two moments swapped"
    ROWS = "moments in rows of the tensor"
    AXES = "moments about other axes"
    MASS = "mass"
    PLACEHOLDER = "placeholder"
    COPY = "copied from another link"


class Hypothesis(NamedTuple):
    """A mistake that may have been made, and the numbers without it.

    Attributes:
        slips: The mistakes, none if all is right.
        body: The numbers as they were meant; as written where that is not known.
        half: How far each of them may be from that.
        weight: How common the mistake is, against the others.
        names: The numbers that are wrong, or that were swapped; the link that was copied; of a
            number typed anew what the file should have.
        power: The moments, or the mass, are to be multiplied by ten to this power.
        unit: The unit that explains that, or empty.
        is_partial: Whether only some of the products' signs are wrong.
        has_products: Whether there are signs to be wrong.
    """

    slips: tuple[Slip, ...]
    body: MassDistribution
    half: MassDistribution
    weight: float
    names: tuple[str, ...] = ()
    power: int = 0
    unit: str = ""
    is_partial: bool = False
    has_products: bool = True

    @property
    def sort(self) -> str:
        """The mistakes of one sort, which are equally common but for their share of it."""
        unit = ("unit" if self.unit else "digit") if {Slip.SCALE, Slip.MASS} & {*self.slips} else ""
        return " + ".join((*self.slips, *filter(None, (unit,))))

    @property
    def code(self) -> str:
        """The rule that tells it: that of its first slip."""
        is_of_mass = self.slips == (Slip.NUMBER,) and self.names[0] == "mass"
        return TABLE[Slip.MASS if is_of_mass else self.slips[0]].code

    @property
    def log_change(self) -> float:
        """The logarithm of how much smaller a volume of moments becomes without the mistake."""
        n_moments = 6.0 if Slip.SCALE in self.slips else 1.0 if Slip.MOMENT in self.slips else 0.0
        return n_moments * self.power * _LOG_TEN

    @property
    def kind(self) -> Kind:
        """The part that is equal where the same mistake was made at another link."""
        return self.slips, self.power, self.unit, self.is_partial and self.names

    @property
    def kinds(self) -> tuple[Kind, ...]:
        """The kinds of mistake that it may be: without products, wrong signs do not show."""
        if self.has_products or self.slips[:1] != (Slip.REFERENCE,):
            return (self.kind,)
        with_signs = self._replace(slips=(Slip.REFERENCE, Slip.SIGNS, *self.slips[1:]))
        return self.kind, with_signs.kind


def hypotheses(
    body: MassDistribution, half: MassDistribution, among: Container[Slip] = frozenset(Slip)
) -> Iterator[Hypothesis]:
    """Yield all mistakes of the table that give numbers, one or two of them at a time.

    Args:
        body: As written.
        half: How far each number may be from what is written.
        among: The mistakes that are tried first.
    """
    for h in _in_table(Hypothesis((), body, half, 1.0, has_products=any(body.moments[3:])), among):
        yield h._replace(weight=h.weight * exp(WEIGHTS.get(h.sort, 0.0)))


def _in_table(written: Hypothesis, among: Container[Slip]) -> Iterator[Hypothesis]:
    for slip, row in TABLE.items():
        for single in row.meant(written) if slip in among else ():
            h = _with(slip, single, row.weight)
            yield h
            for other, share, of_some in _PAIRS.get(slip, ()):
                if slip is Slip.SCALE and h.power > _GREATEST_OF_PAIR:
                    continue
                for both in TABLE[other].meant(h):
                    weight = TABLE[other].weight * (of_some if both.is_partial else share)
                    pair = _with(other, both, weight)
                    # The unit is told, and mended, first.
                    yield pair._replace(slips=pair.slips[::-1]) if slip is Slip.SCALE else pair


def _with(slip: Slip, h: Hypothesis, weight: float) -> Hypothesis:
    return h._replace(slips=(slip, *h.slips), weight=weight * h.weight)


def likely_lengths(distance: float) -> list[tuple[str, float]]:
    """Return the units that the distance of a CoM may well be in, the likeliest first.

    Args:
        distance: As written, too far to be in metres.

    Returns:
        Each with its probability among all units.
    """
    said = {u: w * exp(TABLES["distance"].at(log(f * distance))) for f, u, w in _LENGTHS}
    whole = sum(said.values())
    likely = sorted(((unit, weight / whole) for unit, weight in said.items()), key=lambda x: -x[1])
    return [each for each in likely if each[1] > _RIVAL]


def _other_signs(h: Hypothesis) -> Iterator[Hypothesis]:
    """Yield products negated: all of them first, as in a pasted tensor."""
    present = [index for index in _PRODUCTS if h.body.moments[index]]
    for count in (len(present), *range(1, len(present))) if present else ():
        share = 1.0 if count == len(present) else 0.35 if count == 1 else 0.1
        for chosen in combinations(present, count):
            yield h._replace(
                body=h.body._replace(moments=_negated(h.body.moments, chosen)),
                weight=share * h.weight,
                names=tuple(MOMENTS[index] for index in chosen),
                is_partial=count < len(present),
            )


def _other_signs_about_com(h: Hypothesis) -> Iterator[Hypothesis]:
    """Yield products about the CoM negated: all, or two, as of a side that was not mirrored."""
    about_com = shifted(h.body, -1.0)
    least = ROUNDING_OF_MOMENTS * max(map(abs, h.body.moments))
    present = [index for index in _PRODUCTS if abs(about_com.moments[index]) > least]
    if not present or not h.has_products or not any(h.body.com):
        return
    for chosen, share in ((_PRODUCTS, 1.0), *((two, 0.1) for two in combinations(_PRODUCTS, 2))):
        negated = about_com._replace(moments=_negated(about_com.moments, chosen))
        yield h._replace(
            body=shifted(negated),
            weight=share * h.weight,
            names=tuple(MOMENTS[index] for index in chosen),
            is_partial=share < 1.0,
        )


def _shifted(share: float, h: Hypothesis) -> Iterator[Hypothesis]:
    if any(h.body.com):
        yield h._replace(body=shifted(h.body, share))


def _scaled(h: Hypothesis) -> Iterator[Hypothesis]:
    for power, unit, share in _UNITS:
        scaled = _changed(h, "moments", partial(_times, 10.0**power))
        yield scaled._replace(weight=share * h.weight, power=power, unit=unit)


def _com_scaled(h: Hypothesis) -> Iterator[Hypothesis]:
    for factor, unit, share in _LENGTHS if any(h.body.com) else ():
        scaled = _changed(h, "com", partial(_times, factor))
        yield scaled._replace(weight=share * h.weight, unit=unit)


def _one_scaled(h: Hypothesis) -> Iterator[Hypothesis]:
    for index, moment in enumerate(h.body.moments[:3]):
        for power in (-1, 1) if moment else ():
            scaled = _changed(h, "moments", partial(_with_one_times, 10.0**power, index))
            yield scaled._replace(names=(MOMENTS[index],), power=power, is_partial=True)


def _other_moment_sign(h: Hypothesis) -> Iterator[Hypothesis]:
    for index, moment in enumerate(h.body.moments[:3]):
        if moment < 0.0:
            body = h.body._replace(moments=_negated(h.body.moments, (index,)))
            yield h._replace(body=body, names=(MOMENTS[index],), is_partial=True)


def _other_com_sign(h: Hypothesis) -> Iterator[Hypothesis]:
    for index, axis in enumerate("xyz"):
        if h.body.com[index]:
            body = h.body._replace(com=_negated(h.body.com, (index,)))
            yield h._replace(body=body, names=(f"the {axis} of the CoM",), is_partial=True)


def _other_com_order(h: Hypothesis) -> Iterator[Hypothesis]:
    for one, other in combinations(range(3), 2):
        if h.body.com[one] != h.body.com[other]:
            order = _exchanged(range(3), one, other)
            names = "xyz"[one], f"{'xyz'[other]} of the CoM"
            yield _changed(h, "com", partial(_ordered, order))._replace(names=names)


def _swapped(h: Hypothesis) -> Iterator[Hypothesis]:
    for group in ((0, 1, 2), (3, 4, 5)):
        for one, other in combinations(group, 2):
            if h.body.moments[one] != h.body.moments[other]:
                yield _in_order(h, _exchanged(range(6), one, other), MOMENTS[one], MOMENTS[other])


def _by_rows(h: Hypothesis) -> Iterator[Hypothesis]:
    if h.has_products:
        yield _in_order(h, _ROWS)


def _about_other_axes(h: Hypothesis) -> Iterator[Hypothesis]:
    for order, names in _TURNS:
        yield _in_order(h, order, names)


def _other_mass(h: Hypothesis) -> Iterator[Hypothesis]:
    for power, unit, share in _MASSES:
        scaled = _changed(h, "mass", partial(mul, 10.0**power))
        yield scaled._replace(weight=share * h.weight, power=power, unit=unit)


def _unknown(_: Hypothesis) -> Iterator[Hypothesis]:
    """Return nothing: the numbers that were meant leave no trace."""
    return iter(())


class SlipRow(NamedTuple):
    """A mistake as the table has it.

    Attributes:
        code: The rule that tells it.
        weight: How common it is.
        meant: The numbers that may have been meant.
    """

    code: str
    weight: float
    meant: Callable[[Hypothesis], Iterator[Hypothesis]]


# How common a mistake is: what published histories correct and other formats have otherwise; what
# comes of a unit or of mirroring by hand; what nobody's history shows. Where each had a number of
# its own, of 3,000 planted slips 29 that have the right cause first now had not, 19 the other way
# round, and 56 fixes fewer were right. Were a mass only seldom wrong, UR5 would get a wrong fix.
_COMMON, _SELDOM, _RARE = 1.0, 0.3, 0.1

TABLE = {
    Slip.REFERENCE: SlipRow("KD306", _COMMON, partial(_shifted, 1.0)),
    Slip.SIGNS: SlipRow("KD307", _COMMON, _other_signs),
    Slip.SIGNS_THERE: SlipRow("KD307", _SELDOM, _other_signs_about_com),
    Slip.SCALE: SlipRow("KD308", _SELDOM, _scaled),
    Slip.COM_UNIT: SlipRow("KD502", _SELDOM, _com_scaled),
    Slip.MOMENT: SlipRow("KD308", _RARE, _one_scaled),
    Slip.MASS: SlipRow("KD314", _RARE, _other_mass),
    Slip.NUMBER: SlipRow("KD308", _RARE, _unknown),
    # No body has a moment below zero, in whatever frame or unit.
    Slip.MINUS: SlipRow("KD307", _COMMON, _other_moment_sign),
    Slip.COM_SIGN: SlipRow("KD307", _SELDOM, _other_com_sign),
    Slip.SWAP: SlipRow("KD307", _RARE, _swapped),
    Slip.ROWS: SlipRow("KD307", _RARE, _by_rows),
    Slip.TWICE: SlipRow("KD306", _RARE, partial(_shifted, -1.0)),
    Slip.COM_ORDER: SlipRow("KD307", _RARE, _other_com_order),
    Slip.AXES: SlipRow("KD307", _RARE, _about_other_axes),
    # Equal round moments are no body's by chance, nor are the same digits in two unlike links.
    Slip.PLACEHOLDER: SlipRow("KD310", 20.0, _unknown),
    Slip.COPY: SlipRow("KD310", 5.0, _unknown),
}

# With which slip another one is tried, and the share of its weight that is left: of all signs
# or none, and of some. URDF negates what it has in rows.
_PAIRS = {
    Slip.SIGNS: ((Slip.REFERENCE, 0.8, 0.01),),
    Slip.SCALE: ((Slip.REFERENCE, 0.03, 0.03), (Slip.SIGNS, 0.03, 0.002)),
    Slip.ROWS: ((Slip.SIGNS, 0.5, 0.01),),
}


def _negated(values: _Values, chosen: Sequence[int]) -> _Values:
    return tuple(-v if i in chosen else v for i, v in enumerate(values))  # type: ignore[return-value]


def _times(factor: float, values: _Values) -> _Values:
    return tuple(factor * value for value in values)  # type: ignore[return-value]


def _with_one_times(factor: float, index: int, values: Symmetric) -> Symmetric:
    return tuple(factor * v if i == index else v for i, v in enumerate(values))  # type: ignore[return-value]


def _in_order(h: Hypothesis, order: Sequence[int], *names: str) -> Hypothesis:
    return _changed(h, "moments", partial(_ordered, order))._replace(names=names)


def _changed(h: Hypothesis, part: str, change: Callable[[Any], Any]) -> Hypothesis:
    """Return a hypothesis with its mass, CoM or moments changed, and the half-widths of these."""
    body, half = (b._replace(**{part: change(getattr(b, part))}) for b in (h.body, h.half))
    return h._replace(body=body, half=half)


def _ordered(order: Sequence[int], values: _Values) -> _Values:
    return tuple(values[index] for index in order)  # type: ignore[return-value]


def _exchanged(places: Sequence[int], one: int, other: int) -> list[int]:
    return [other if place == one else one if place == other else place for place in places]
