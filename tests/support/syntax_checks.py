"""What must hold of any parsed document."""

from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.tree import Edit, Island, Node, Problem
from kindsl.language.text.edits import TextEdit, apply_edits


def assert_lossless(document: SyntaxDocument, text: str) -> None:
    """Check that islands, tokens and nodes tile the text."""
    assert document.text == text
    assert document.length == len(text)
    assert "".join(island.text for island in document.islands) == text
    for island in document.islands:
        _assert_tiled(island)


def _assert_tiled(island: Island) -> None:
    done = 0
    for token in island.tokens:
        assert token.lead == done
        assert token.lead <= token.start <= token.end
        done = token.end
    assert done <= len(island.text)
    skipped = {id(token) for token in island.skipped}
    read = [id(token) for token in island.tokens if id(token) not in skipped]
    assert read == [id(token) for node in island.nodes for token in node.tokens()]
    for problem in island.problems:
        assert 0 <= problem.start <= problem.end <= len(island.text)
    for node in island.nodes:
        assert_whole_vectors(node)


def assert_whole_vectors(block: Node) -> None:
    """Check that all vectors of a block have three components, repaired or not."""
    pending = [block]
    while pending:
        node = pending.pop()
        if node.kind == "vector":
            shape = [None if isinstance(child, Node) else child.kind for child in node.children]
            assert shape == ["(", None, ",", None, ",", None, ")"]
        pending += [child for child in node.children if isinstance(child, Node)]


def assert_same(left: SyntaxDocument, right: SyntaxDocument) -> None:
    """Check that two documents have equal islands, trees and problems, and no island twice."""
    assert len({id(island) for island in left.islands}) == len(left)
    assert [island.text for island in left.islands] == [island.text for island in right.islands]
    for one, other in zip(left.islands, right.islands, strict=True):
        assert repr(one.tokens) == repr(other.tokens)
        assert repr(one.nodes) == repr(other.nodes)
        assert one.problems == other.problems
        assert one.comments == other.comments
    assert placed(left) == placed(right)
    assert left.starts == right.starts


def placed(document: SyntaxDocument) -> list[tuple[int, Problem]]:
    """Return all problems with the absolute offset of their island, in order."""
    found = [
        (start, problem)
        for start, island in zip(document.starts, document.islands, strict=True)
        for problem in island.problems
    ]
    found += [(document.starts[p.number], p.problem) for p in document.problems]
    return sorted(found, key=lambda entry: (entry[0] + entry[1].start, entry[1].code))


def repaired(document: SyntaxDocument) -> str:
    """Return the text after all repairs, of several to choose from the first."""
    edits = [
        absolute(start, edit)
        for start, problem in placed(document)
        for repair in (problem.repair or next(iter(problem.choices), None),)
        for edit in (repair.edits if repair else ())
    ]
    return apply_edits(document.text, edits)


def absolute(start: int, edit: Edit) -> TextEdit:
    """Return an edit of an island that begins at `start` as one of the document."""
    return TextEdit(start + edit.start, start + edit.end, edit.text)
