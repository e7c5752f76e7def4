"""The kinds of words that are highlighted, announced before what finds them is loaded."""

TYPES = (
    "namespace", "class", "method", "property", "parameter", "variable", "keyword", "number",
    "comment", "operator",
)  # fmt: skip
MODIFIERS = ("declaration", "readonly", "modification", "defaultLibrary", "deprecated")
