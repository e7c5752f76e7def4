"""One island's text to its tree; any text whatever."""

from kindsl.syntax.builder import build
from kindsl.syntax.scanner import comments, scan
from kindsl.syntax.tree import Island, Node, Problem, Token

STARTS = {
    "Robot": "head",
    "RobotBase": "base",
    "link": "link",
    "JOINT_KIND": "joint",
    "}": "end",
}


def parse_island(text: str) -> Island:
    """Return the island of a text, with its nodes and what is wrong in it."""
    tokens = scan(text)
    nodes: list[Node] = []
    problems: list[Problem] = []
    skipped: list[Token] = []
    index = 0
    while index < len(tokens):
        start = STARTS.get(tokens[index].kind)
        node, count = build(tokens, start, index) if start else (None, index)
        if node is None:
            token = tokens[min(count, len(tokens) - 1)]
            problems.append(
                Problem("KD001", f"unexpected '{token.text}'", token.start, token.end)
            )
            skipped = tokens[index:]
            break
        nodes.append(node)
        index = count
    return Island(
        text, tuple(nodes), tuple(tokens), tuple(skipped), comments(text), tuple(problems)
    )
