"""Places with broken syntax, from which nothing can be concluded."""

from kindsl.language.semantics.model import Model
from kindsl.language.semantics.parameters import Parameter


def is_doubtful(parameter: Parameter) -> bool:
    """Return whether all places of a parameter are in broken text: it may be no parameter."""
    return all(use.name.island.problems for use in parameter.uses)


def is_greek_pi(name: str) -> bool:
    """Return whether a name is the letter for the number pi, in whatever style it is set."""
    # Imported for parameters only, since it delays the linter's start.
    from unicodedata import normalize

    return normalize("NFKC", name) == "\N{GREEK SMALL LETTER PI}"


def is_cut_off(model: Model) -> bool:
    """Return whether the document's end is missing, so that blocks may be missing too."""
    return not any(node.kind == "end" for island in model.islands[-2:] for node in island.nodes)
