"""Explain a finding's code, such as KD301: what it means, why it matters, how to repair it."""

from kindsl.frontends.mcp.folder import Folder, ToolError
from kindsl.frontends.mcp.tool import Arguments, Content, Field, text
from kindsl.judgement.rules.registry import all_rules, page_of
from kindsl.language.text.nearest import hint, nearest_name


class CodeArguments(Arguments):
    """A code."""

    code: str = Field(description="The code of a finding, or the rule's name")


def run(arguments: CodeArguments, _folder: Folder) -> list[Content]:
    """Return the page of the rule."""
    wanted = arguments.code.strip()
    names = {name: rule for rule in all_rules() for name in (rule.code, rule.name)}
    rule = names.get(wanted.upper()) or names.get(wanted.lower())
    if rule is None:
        near = hint(nearest_name(wanted.upper(), list(names)), after=",")
        raise ToolError(f"there is no rule '{wanted}'{near}; 'check' names the codes")
    return [text(f"# {rule.name} ({rule.code})\n\n{page_of(rule)}\n")]
