"""`--explain` and `--list-rules`: the pages of the rules."""

from typing import Any

from kindsl.judgement.rules.base import Rule
from kindsl.judgement.rules.page_files import page_address
from kindsl.judgement.rules.registry import all_rules, page_of


def summary_of(rule: Rule) -> str:
    """Return the first sentence of a rule's page."""
    return page_of(rule).partition("\n\n")[0].replace("\n", " ")


def explained(rule: Rule) -> str:
    """Return a rule's page with its heading."""
    return f"# {rule.name} ({rule.code})\n\n{_facts(rule)}\n\n{page_of(rule)}\n"


def explained_as_json(rule: Rule) -> str:
    """Return a rule and its page as a JSON object."""
    import json

    return json.dumps({**_entry(rule), "explanation": page_of(rule)}, indent=2) + "\n"


def rule_list() -> str:
    """Return a table of all rules."""
    rows = [(rule.code, rule.name, rule.severity.value, summary_of(rule)) for rule in all_rules()]
    width = max(len(row[1]) for row in rows)
    return "".join(
        f"{code}  {name:{width}}  {level:7}  {what}\n" for code, name, level, what in rows
    )


def rule_list_as_json() -> str:
    """Return all rules as a JSON array."""
    import json

    return json.dumps([_entry(rule) for rule in all_rules()], indent=2) + "\n"


def _facts(rule: Rule) -> str:
    when = "" if rule.is_default else ", off unless selected or needed by a target"
    return f"Severity: {rule.severity.value}{when}"


def _entry(rule: Rule) -> dict[str, Any]:
    return {
        "code": rule.code,
        "name": rule.name,
        "severity": rule.severity.value,
        "default": rule.is_default,
        "summary": summary_of(rule),
        "url": page_address(rule.code),
    }
