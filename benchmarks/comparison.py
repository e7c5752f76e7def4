"""How right comparisons of robots are, and how long they take: `python benchmarks/comparison.py`.

Each robot is written as a URDF with its link frames, names, order, signs and fixed links at random;
then one number of the document, or of the URDF, is changed by 1 %. `--number N` tries so many.
"""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
sys.path.insert(0, str(ROOT / "tests" / "interchange"))
