"""A URDF: a document that reads without an error of syntax, or one clear sentence.

Input: the file's bytes.
"""

import tempfile
from pathlib import Path

from kindsl.analysis.analysis import analyse
from kindsl.interchange.kindsl_writing import kindsl_text
from kindsl.interchange.urdf.checking import UrdfError
from kindsl.interchange.urdf.urdf_reading import read_urdf


def one_input(data: bytes) -> None:
    """Convert a URDF, with a fixed and a floating base."""
    with tempfile.NamedTemporaryFile(suffix=".urdf") as file:
        file.write(data)
        file.flush()
        for is_floating in (False, True):
            try:
                read = read_urdf(Path(file.name), floating=is_floating)
            except UrdfError as error:
                assert str(error) and not str(error).endswith(".")
                continue
            text = kindsl_text(read.robot)
            found = [f for f in analyse(text).findings if f.code.startswith(("KD0", "KD1", "KD2"))]
            assert found == [], f"{found[0].message}\n{text}"
