"""The reader of RobCoGen2 itself: robot-model-tools, asked in this process."""

import logging
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple


class Answer(NamedTuple):
    """What a reader makes of a document.

    Attributes:
        reads: Whether it takes it.
        says: What it says if not.
        models: What it read: connectivity, order, frames, geometry, inertia.
    """

    reads: bool
    says: str = ""
    models: Any = None


def robot_model_tools(text: str, folder: Path) -> Answer:
    """Ask robot-model-tools.

    Args:
        text: The document; lone surrogates stand for bytes that are not UTF-8.
        folder: Where it may write the file that it reads.
    """
    language, importer = _reader()
    path = folder / "document.kindsl"
    path.write_bytes(text.encode("utf-8", "surrogateescape"))
    language._resetState()
    logging.disable(logging.CRITICAL)
    try:
        return Answer(True, models=importer.convert(language.modelFromFile(str(path))))
    except Exception as error:
        return Answer(False, f"{type(error).__name__}: {error}")
    finally:
        logging.disable(logging.NOTSET)


@cache
def _reader() -> tuple[Any, Any]:
    import robmodel.convert.kindsl.imp as reading

    return reading.KinematicsDSL(), reading.Importer()
