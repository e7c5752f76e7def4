"""What these tools say of a document for a target, to be held against the generator itself."""

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings

# Rules that speak of loading; others are errors too, of robots that cannot be.
LOADING = ("KD0", "KD105", "KD106", "KD107", "KD108", "KD6")


def is_read(text: str, target: str) -> bool:
    """Return whether there is no error of loading with that target named."""
    found = analyse(text, Settings(frozenset([target]))).findings
    return not any(f.severity == "error" and f.code.startswith(LOADING) for f in found)
