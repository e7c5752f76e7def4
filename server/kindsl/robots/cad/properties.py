"""Mass properties of one body, its numbers as the document takes them."""

from dataclasses import dataclass, replace

from kindsl.language.syntax.vocabulary import MOMENTS

SixTexts = tuple[str, str, str, str, str, str]


@dataclass(frozen=True, slots=True)
class MassProperties:
    """Mass properties in the frame that they were reported in; numbers as the document takes them.

    Attributes:
        program: The program or shape that they come from.
        mass: Kilograms.
        com: Centre of mass, metres.
        moments: `Ix Iy Iz Ixy Ixz Iyz` about the frame's origin and axes, kg·m².
        sign: +1 where the report's products are the language's, -1 where they are negated; None
            where its digits do not decide, and then the moments have them as reported.
        other_moments: The moments by the other sign, where that is not decided.
        system: The coordinate system that the report names, empty for the default one.
        notes: Remarks, a sentence each.
    """

    program: str
    mass: str
    com: tuple[str, str, str]
    moments: SixTexts
    sign: int | None = 1
    other_moments: SixTexts | None = None
    system: str = ""
    notes: tuple[str, ...] = ()

    def __str__(self) -> str:
        """Return the block of the language."""
        return self.block()

    def block(self, keyword: str = "inertia_params", indent: str = "", frame: str = "") -> str:
        """Return the block of the language.

        Args:
            keyword: The word that opens it.
            indent: Blanks before each line but the first.
            frame: The link's frame that the numbers are in, empty for the link frame.
        """
        lines = [
            f"mass = {self.mass}",
            f"CoM = ({', '.join(self.com)})",
            *(f"{name} = {text}" for name, text in zip(MOMENTS, self.moments, strict=True)),
            *([f"ref_frame = {frame}"] if frame else []),
        ]
        body = "".join(f"{indent}    {line}\n" for line in lines)
        return f"{keyword} {{\n{body}{indent}}}"

    def by_sign(self, sign: int) -> "MassProperties":
        """Return the same with its products read by one of the two conventions."""
        moments = self.moments if sign > 0 or self.other_moments is None else self.other_moments
        return replace(self, moments=moments, sign=sign, other_moments=None)
