"""What the linter says, as a page lists it."""

from tests.cli.samples import GOOD

from kindsl.frontends.preview.findings import MOST_LISTED, finding_messages, listed, status_message
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.rules.base import Severity
from kindsl.language.semantics.unknown import Unknown
from kindsl.robots.mechanism.total_mass import Weight
from kindsl.robots.scene.encoding import as_dict
from kindsl.robots.scene.picture import Picture, PictureState


class TestFindings:
    """What is listed over the picture."""

    def test_the_worst_are_listed_first_and_not_more_than_help(self) -> None:
        text = GOOD.replace("(0.5,", "(1,")
        (error,) = analyse(text).findings
        hint = error._replace(severity=Severity.HINT)
        warning = error._replace(severity=Severity.WARNING)
        order = [f.severity for f in listed([hint, warning, error, hint])]
        assert order == [Severity.ERROR, Severity.WARNING, Severity.HINT, Severity.HINT]
        assert MOST_LISTED == 40 and len(listed([hint] * 41)) == 40
        messages = list(finding_messages([hint, error], text))
        assert as_dict(messages[0]) == {
            "type": "finding", "path": "/kindsl/findings/0", "index": 0, "code": "KD005",
            "severity": "error", "message": error.message, "line": 21, "column": 32,
        }  # fmt: skip
        assert (messages[1].index, messages[1].severity) == (1, "hint")
        assert finding_messages([], text) == []

    def test_status_counts_all(self) -> None:
        (error,) = analyse(GOOD.replace("(0.5,", "(1,")).findings
        drawn = Picture(None, PictureState.BROKEN, "why", weight=Weight(2.5, 1, Unknown("why not")))
        found = status_message(drawn, [error] * 50, "arm.kindsl")
        assert as_dict(found) == {
            "type": "status", "path": "/kindsl/status", "state": "broken", "message": "why",
            "total": 50, "counts": {"error": 50}, "label": "arm.kindsl",
            "mass": 2.5, "lacks": "why not", "is_former": False,
        }  # fmt: skip
        lost = {"state": "gone", "message": "gone", "total": 3, "counts": {}, "is_former": True}
        gone = status_message(drawn, [error] * 3, "arm.kindsl", "gone")
        assert as_dict(gone) == {**as_dict(found), **lost}
        assert as_dict(status_message(None, [error] * 3, "arm.kindsl", "gone")) == {
            "type": "status", "path": "/kindsl/status", "label": "arm.kindsl",
            "mass": 0.0, "lacks": "", **lost,
        }  # fmt: skip
