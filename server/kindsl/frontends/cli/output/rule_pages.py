"""`--explain` and `--list-rules`: the pages of the rules."""

from typing import Any

from kindsl.frontends.cli.outcome import UnknownRuleError
from kindsl.judgement.rules.base import Rule
from kindsl.judgement.rules.registry import all_rules, page_address, page_of
from kindsl.language.text.nearest import hint, nearest_word


def pages(name: str | None, output_format: str) -> str:
    """Return the page of a rule, or the list of all, as text or JSON.

    Raises:
        UnknownRuleError: No rule has that code or name.
    """
    if name is None:
        return _json([_entry(each) for each in all_rules()]) if output_format == "json" else _list()
    known = {word.upper(): rule for rule in all_rules() for word in (rule.code, rule.name)}
    rule = known.get(name.upper())
    if rule is None:
        words = (word for rule in known.values() for word in (rule.code, rule.name))
        near = hint(nearest_word(name.upper(), words), after=",")
        raise UnknownRuleError(f"no rule '{name}'{near}; see --list-rules")
    page = page_of(rule)
    if output_format != "json":
        when = "" if rule.is_default else ", off unless selected or needed by a target"
        facts = f"Severity: {rule.severity.value}{when}"
        return f"# {rule.name} ({rule.code})\n\n{facts}\n\n{page}\n"
    return _json({**_entry(rule), "explanation": page})


def summary_of(rule: Rule) -> str:
    """Return the first sentence of a rule's page."""
    return page_of(rule).partition("\n\n")[0].replace("\n", " ")


def _list() -> str:
    rows = [(rule.code, rule.name, rule.severity.value, summary_of(rule)) for rule in all_rules()]
    width = max(len(row[1]) for row in rows)
    return "".join(
        f"{code}  {name:{width}}  {level:7}  {what}\n" for code, name, level, what in rows
    )


def _json(data: Any) -> str:
    import json

    return json.dumps(data, indent=2) + "\n"


def _entry(rule: Rule) -> dict[str, Any]:
    return {
        "code": rule.code,
        "name": rule.name,
        "severity": rule.severity.value,
        "default": rule.is_default,
        "summary": summary_of(rule),
        "url": page_address(rule.code),
    }
