"""What inputs are made of: the targets, their fixed corpus and their words."""

from pathlib import Path

FOLDER = Path(__file__).parent
TARGETS = sorted(path.stem for path in (FOLDER / "targets").glob("*.py"))


def corpus(target: str) -> list[Path]:
    """Return the files with a target's inputs."""
    return sorted((FOLDER / "corpus" / target).iterdir())


def words(target: str) -> list[bytes]:
    """Return the words that a target's inputs are made of; a file has one a line, escaped."""
    lines = (FOLDER / "words" / f"{target}.txt").read_text(encoding="ascii").splitlines()
    return [line.encode().decode("unicode_escape").encode("latin-1") for line in lines]
