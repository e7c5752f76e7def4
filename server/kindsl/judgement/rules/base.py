"""Rules and their findings."""

from collections.abc import Callable, Iterator
from enum import StrEnum
from typing import NamedTuple

from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.subject import Subject
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Declarations, Joint, Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Located, Place
from kindsl.language.syntax.tree import Island, Repair


class Severity(StrEnum):
    """The severity of a finding."""

    ERROR = "error"
    WARNING = "warning"
    INFORMATION = "info"
    HINT = "hint"


class Tag(StrEnum):
    """The way an editor may draw a finding."""

    UNNECESSARY = "unnecessary"


class Related(NamedTuple):
    """Another place that belongs to a finding, and a message about it."""

    at: Located
    message: str


class Replacement(NamedTuple):
    """Replace the text at a place; an empty place inserts."""

    at: Located
    text: str


class Fix(NamedTuple):
    """The fix of a finding.

    Attributes:
        is_safe: Whether it keeps what the document means. The claim is tested: a fix that
            changes a number, or may change one, is not safe.
        is_within_digits: Whether it may give a number a value that has the digits written.
    """

    title: str
    changes: tuple[Replacement, ...]
    is_safe: bool = False
    is_within_digits: bool = False


def renaming(at: Located, name: str, meant: str) -> Fix:
    """Return the fix that writes the name that was meant."""
    return Fix(f"Replace '{name}' with '{meant}'", (Replacement(at, meant),))


def fix_of(repair: Repair, island: Island) -> Fix:
    """Return a repair of an island's text as a fix."""
    changes = tuple(Replacement(Place(island, e.start, e.end), e.text) for e in repair.edits)
    return Fix(repair.title, changes, repair.is_safe)


class Finding(NamedTuple):
    """Something that a rule found.

    Attributes:
        message: One sentence without final period: what is wrong, names quoted, with units.
        choices: Edits that fix it where several things may be meant; then there is no `fix`.
        severity: Where it differs from the rule's.
        explains: Codes of findings about the same things that it makes needless, but for their
            fixes where it has none.
        subject: The thing that it is about, if not the one in whose text `at` lies.
        probability: Of the cause that the message names, where one was weighed against others.
        also: Where other things are that it is about as well.
    """

    at: Located
    message: str
    related: tuple[Related, ...] = ()
    fix: Fix | None = None
    severity: Severity | None = None
    tag: Tag | None = None
    choices: tuple[Fix, ...] = ()
    explains: frozenset[str] = frozenset()
    subject: Subject | None = None
    probability: float | None = None
    also: tuple[Located, ...] = ()


DocumentCheck = Callable[[Model, Context], Iterator[Finding]]
BodyCheck = Callable[[Link, tuple[Joint, ...], Context], Iterator[Finding]]
IslandCheck = Callable[[Declarations, Context], Iterator[Finding]]


class Rule(NamedTuple):
    """A rule; its module's docstring is its page.

    A rule has one of three checks. `check_island` sees what one island declares and its result is
    kept until that island, or a value that it uses, changes; so a check of a link alone belongs
    there. `check_body` sees a body and the joints by which it carries others: its
    result is kept until the island of one of them changes. `check_document` sees the whole model;
    its result is kept until what `reads` names changes, or an island to which a finding points. The
    rules of the syntax have none: the parser finds them.

    Attributes:
        module: Where it is, which is named after its code and its name.
        reads: All that `check_document` reads of the document besides its structure.
        reads_twins: Whether `check_document` reads other files of the robot, too.
        is_default: Whether it runs without being selected or needed by a target.
    """

    module: str
    severity: Severity
    check_document: DocumentCheck | None = None
    check_island: IslandCheck | None = None
    check_body: BodyCheck | None = None
    reads: Aspect = Aspect.ALL
    reads_twins: bool = False
    is_default: bool = True

    @property
    def code(self) -> str:
        """`KD` and three digits, never reused."""
        return self.module.rpartition(".")[2].partition("_")[0].upper()

    @property
    def name(self) -> str:
        """The defect in a word or few, hyphenated."""
        return self.module.rpartition(".")[2].partition("_")[2].replace("_", "-")
