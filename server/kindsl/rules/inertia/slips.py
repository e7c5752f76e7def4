"""Mistakes in copying ten numbers, and the numbers as they were meant."""

from collections.abc import Iterator, Sequence
from enum import StrEnum
from itertools import combinations
from typing import NamedTuple, TypeVar

from kindsl.rigid.body import MassDistribution, Symmetric, shifted
from kindsl.rigid.pose import Vector3
from kindsl.syntax.vocabulary import MOMENTS

_Values = TypeVar("_Values", Symmetric, Vector3)

Kind = tuple[object, ...]

_PRODUCTS = (3, 4, 5)
# What people write moments in: CAD programs in grams or kilograms, finite elements in tonnes.
_UNITS = (
    (-9, "g·mm²", 0.4),
    (-6, "kg·mm²", 0.4),
    (-7, "g·cm²", 0.4),
    (-4, "kg·cm²", 0.4),
    (-3, "t·mm²", 0.1),
)
_OTHER_POWERS = (-1, 1, -2, 2, 3, 4, 6)
_RARE = 1e-5
_MASS_POWERS = ((-3, 1e-3), (-1, _RARE), (1, _RARE))


class Slip(StrEnum):
    """A simple mistake."""

    SIGNS = "signs"
    REFERENCE = "reference"
    SCALE = "scale"
    COM_SIGN = "sign of the CoM"
    SWAP = "two moments swapped"
    MASS = "mass"


class Hypothesis(NamedTuple):
    """A mistake that may have been made, and the numbers without it.

    Attributes:
        slips: What was done wrong, one or more things; none if nothing was.
        body: The numbers as they were meant.
        half: How far each of them may be from that.
        weight: How common the mistake is, against the others.
        names: The numbers whose sign is wrong, or that were swapped.
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
    def is_last_resort(self) -> bool:
        """True if it is a digit too many or too few, which can mend nearly everything."""
        return bool(self.power) and not self.unit

    @property
    def kind(self) -> Kind:
        """The part that is equal where the same mistake was made at another link."""
        return self.slips, self.power, self.is_partial and self.names

    @property
    def kinds(self) -> tuple[Kind, ...]:
        """The kinds of mistake that it may be: without products, wrong signs do not show."""
        if self.has_products or self.slips[:1] != (Slip.REFERENCE,):
            return (self.kind,)
        with_signs = self._replace(slips=(Slip.REFERENCE, Slip.SIGNS, *self.slips[1:]))
        return self.kind, with_signs.kind


def hypotheses(body: MassDistribution, half: MassDistribution) -> Iterator[Hypothesis]:
    """Yield all mistakes that are told apart, one or two of them at a time."""
    written = Hypothesis((), body, half, 1.0, has_products=any(body.moments[3:]))
    yield from _about_tensor(written)
    for scaled in _scaled(written):
        yield scaled
        if scaled.unit:
            for h in _about_tensor(scaled):
                share = 0.002 if h.is_partial else 0.03
                yield h._replace(weight=share * h.weight)
    yield from _with_com_sign(written)
    yield from _swapped(written)
    yield from _with_other_mass(written)


def _about_tensor(h: Hypothesis) -> Iterator[Hypothesis]:
    """Yield slips of signs and reference point, and both together."""
    signs = list(_with_other_signs(h))
    yield from signs
    if any(h.body.com):
        yield _about_origin(h)
        for other in signs:
            share = 0.01 if other.is_partial else 0.8
            yield _about_origin(other._replace(weight=share * other.weight))


def _with_other_signs(h: Hypothesis) -> Iterator[Hypothesis]:
    """Yield products negated: all of them first, as in a pasted tensor."""
    present = [index for index in _PRODUCTS if h.body.moments[index]]
    for count in (len(present), *range(1, len(present))) if present else ():
        share = 1.0 if count == len(present) else 0.35 if count == 1 else 0.1
        for chosen in combinations(present, count):
            yield h._replace(
                slips=(Slip.SIGNS, *h.slips),
                body=h.body._replace(moments=_negated(h.body.moments, chosen)),
                weight=share * h.weight,
                names=tuple(MOMENTS[index] for index in chosen),
                is_partial=count < len(present),
            )


def _about_origin(h: Hypothesis) -> Hypothesis:
    slips = (Slip.REFERENCE, *h.slips)
    return h._replace(slips=slips, body=shifted(h.body))


def _scaled(h: Hypothesis) -> Iterator[Hypothesis]:
    powers = (*_UNITS, *((power, "", _RARE) for power in _OTHER_POWERS))
    for power, unit, weight in powers:
        yield h._replace(
            slips=(Slip.SCALE, *h.slips),
            body=h.body._replace(moments=_times(10.0**power, h.body.moments)),
            half=h.half._replace(moments=_times(10.0**power, h.half.moments)),
            weight=weight * h.weight,
            power=power,
            unit=unit,
        )


def _with_com_sign(h: Hypothesis) -> Iterator[Hypothesis]:
    for index, axis in enumerate("xyz"):
        if h.body.com[index]:
            com: Vector3 = _negated(h.body.com, (index,))
            body = h.body._replace(com=com)
            name = f"the {axis} of the CoM"
            slips = (Slip.COM_SIGN,)
            yield h._replace(slips=slips, body=body, weight=0.05, names=(name,), is_partial=True)


def _swapped(h: Hypothesis) -> Iterator[Hypothesis]:
    for group in ((0, 1, 2), (3, 4, 5)):
        for one, other in combinations(group, 2):
            if h.body.moments[one] != h.body.moments[other]:
                order = list(range(6))
                order[one], order[other] = other, one
                yield h._replace(
                    slips=(Slip.SWAP,),
                    body=h.body._replace(moments=_ordered(h.body.moments, order)),
                    half=h.half._replace(moments=_ordered(h.half.moments, order)),
                    weight=0.02,
                    names=(MOMENTS[one], MOMENTS[other]),
                )


def _with_other_mass(h: Hypothesis) -> Iterator[Hypothesis]:
    for power, weight in _MASS_POWERS:
        yield h._replace(
            slips=(Slip.MASS,),
            body=h.body._replace(mass=h.body.mass * 10.0**power),
            half=h.half._replace(mass=h.half.mass * 10.0**power),
            weight=weight,
            power=power,
        )


def _negated(values: _Values, chosen: Sequence[int]) -> _Values:
    return tuple(-v if i in chosen else v for i, v in enumerate(values))  # type: ignore[return-value]


def _times(factor: float, moments: Symmetric) -> Symmetric:
    return tuple(factor * moment for moment in moments)  # type: ignore[return-value]


def _ordered(moments: Symmetric, order: Sequence[int]) -> Symmetric:
    return tuple(moments[index] for index in order)  # type: ignore[return-value]
