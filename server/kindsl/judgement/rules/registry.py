"""All rules, found by walking `checks`: a file named after a code holds one."""

from functools import cache
from importlib import import_module

from kindsl.judgement.rules import checks
from kindsl.judgement.rules.base import Rule
from kindsl.language.text.modules import module_names

# Rules that judge a link of any format as they judge ours.
OF_PARTS = frozenset(("KD301", "KD302", "KD303", "KD311"))
# Rules that look at nothing but XML.
OF_XML = frozenset(("KD315", "KD521", "KD522", "KD523", "KD524", "KD525", "KD526"))
# Rules that ask of a document's bodies and limbs what others ask of those of a URDF.
OF_BOTH = OF_PARTS | {
    "KD208", "KD209", "KD210", "KD304", "KD306", "KD307", "KD309", "KD310", "KD312", "KD313",
    "KD502", "KD509", "KD510", "KD511",
}  # fmt: skip
CONCERN_XML = OF_PARTS | OF_XML | {"KD501"}
# Rules that parsers, the configuration or comments report.
_WITHOUT_CHECK = ("KD0", "KD404", "KD527", "KD704", "KD706", "KD8", "KD902")
_IN_XML = """

## In a URDF
`Ix` is `ixx` there, `Iy` and `Iz` likewise; `Ixy` is `ixy` with the opposite sign. They are about
the centre of mass, which is the `<origin>` of the `<inertial>`, and along its axes. A zero without
a point is exact, that of a moment as the moments beside it are. Links that are fixed together are
one body. A fix changes whole numbers or names, and is offered where a cause is told with 95 % or
more, or where like limbs tell what one of them should have. A comment
`<!-- kindsl: ignore[CODE] why -->` in an element, or before it, silences the rule there."""


@cache
def all_rules() -> tuple[Rule, ...]:
    """Return the rules in the order of their codes."""
    return rules_with(frozenset(all_codes()))


@cache
def checking_rules() -> tuple[Rule, ...]:
    """Return the rules that look at a document's model, loading no others."""
    others = (*_WITHOUT_CHECK, *OF_XML)
    return rules_with(frozenset(code for code in all_codes() if not code.startswith(others)))


@cache
def rules_with(codes: frozenset[str]) -> tuple[Rule, ...]:
    """Return the rules with some codes, without loading any other."""
    names = (n for n in _module_names() if n.partition("_")[0].upper() in codes)
    return tuple(import_module(f"{checks.__name__}.{name}").RULE for name in names)


@cache
def all_codes() -> tuple[str, ...]:
    """Return the codes of all rules, without loading one."""
    return tuple(sorted(name.partition("_")[0].upper() for name in _module_names()))


def rule_named(code: str) -> Rule | None:
    """Return the rule with a code or a name, whatever its case."""
    wanted = code.lower()
    return next((r for r in all_rules() if wanted in (r.code.lower(), r.name)), None)


def page_of(rule: Rule) -> str:
    """Return the docs page of a rule: its module docstring and the section on XML."""
    page = (import_module(rule.module).__doc__ or "").strip()
    return page + _IN_XML.replace("CODE", rule.code) if rule.code in OF_BOTH else page


@cache
def page_address(code: str) -> str | None:
    """Return the `file:` address of a rule's page, None where the pages were not installed.

    It is in the installed package, or in the checkout around it, so that a rule is explained
    wherever it is reported, offline.
    """
    # pathlib costs the linter start-up time, and most runs show no address.
    from pathlib import Path

    package = Path(__file__).resolve().parents[2]
    for folder in (package, package.parents[1]):
        page = folder / "docs" / "rules" / f"{code.lower()}.md"
        if page.is_file():
            return page.as_uri()
    return None


def _module_names() -> list[str]:
    return [name for name in module_names(checks) if name.startswith("kd")]
