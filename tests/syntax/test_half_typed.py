"""What is said while someone types: what is there, and what is wanted."""

import random
import re
from pathlib import Path

import pytest

from kindsl.judgement.analysis.analysis import analyse

EXAMPLES = Path(__file__).parents[2] / "examples"
HEAD = "Robot R {\nRobotBase base {\n    children {\n        upper via turn\n    }\n}\n"
LINK = HEAD + "link upper {\n    id = 1\n"
INERTIA = LINK + "    inertia_params {\n        mass = 1.0\n"
JOINT = LINK + "    children {}\n}\nr_joint turn {\n"
FRAME = JOINT + "    ref_frame {\n"


@pytest.mark.parametrize(
    ("before", "half", "behind", "message"),
    [
        (HEAD, "Ro", "\n}\n", "expected a robot, a link or a joint instead of 'Ro'"),
        (HEAD, "li", "\n}\n", "expected a robot, a link or a joint instead of 'li'"),
        (LINK, "    child", "\n}\n}\n", "unknown keyword 'child', did you mean 'children'"),
        (INERTIA, "        CoM", "\n    }\n    children {}\n}\n}\n", "expected '=' after 'CoM'"),
        (INERTIA, "        Ix", "\n    }\n    children {}\n}\n}\n", "expected '=' after 'Ix'"),
        (JOINT, "    ref_fr", "\n}\n}\n", "unknown keyword 'ref_fr', did you mean 'ref_frame'"),
        (FRAME, "        translation", "\n    }\n}\n}\n", "expected '=' after 'translation'"),
        (FRAME, "        translation = (", "\n    }\n}\n}\n", "expected a number after '('"),
        (FRAME, "        translation = (0.0", "\n    }\n}\n}\n", "expected ',' after '0.0'"),
        (FRAME, "        translation = (0.", "\n    }\n}\n}\n", "expected ',' after '0.'"),
        (FRAME, "        translation = (a, b,", "\n    }\n}\n}\n", "expected a number after ','"),
        (
            FRAME,
            "        translation = (a, b, PI/2.0",
            "\n    }\n}\n}\n",
            "expected ')' after '2.0'",
        ),
    ],
)
def test_it_is_told_what_comes_next(before: str, half: str, behind: str, message: str) -> None:
    found = analyse(before + half + behind).findings
    told = [d.message for d in found if d.code in ("KD001", "KD002", "KD010")]
    assert told == [message]


def test_what_a_message_quotes_ends_with_its_line() -> None:
    """No message runs on over a brace or into what stands on the next line."""
    chance = random.Random(12)
    for name in ("broken_arm", "fancy", "quadruped"):
        text = (EXAMPLES / f"{name}.kindsl").read_text()[:3000]
        for end in chance.sample(range(len(text)), 25):
            for behind in ("", "\n}\n", " }\n    }\n}\n}\n"):
                for found in analyse(text[:end] + behind).findings:
                    if found.code.startswith("KD00"):
                        quoted = re.findall(r"(?:unexpected|instead of) '(.*)'$", found.message)
                        runs_on = [q for q in quoted if len(q) > 1 and set("{}") & set(q)]
                        assert runs_on == [], (found.message, text[:end][-60:] + behind)
