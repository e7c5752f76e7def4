"""The robots that most tests are about; a test replaces what it is about.

`ARM` has two links, a revolute and a prismatic joint and a frame at the parameter `reach`; `LIFT`
the same of numbers alone. `STUB` is one link with every kind of section, `ONE_LINK` the least that
moves, its mass a parameter `m`.
"""

from pathlib import Path

_FOLDER = Path(__file__).parents[1] / "fixtures" / "robots"

ARM = (_FOLDER / "arm.kindsl").read_text(encoding="utf-8")
LIFT = (_FOLDER / "lift.kindsl").read_text(encoding="utf-8")
ONE_LINK = (_FOLDER / "one_link.kindsl").read_text(encoding="utf-8")
STUB = (_FOLDER / "stub.kindsl").read_text(encoding="utf-8")
