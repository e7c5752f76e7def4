"""What holds of the findings in any text."""

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.edits import apply_edits

EVERYTHING = Settings(
    targets=frozenset({"robcogen", "robcogen2"}),
    select=("KD",),
    bindings={"x": Binding(0.0, -1.0, 1.0), "offset": Binding(1e308), "k": Binding(float("nan"))},
)


def assert_sound(analysis: Analysis) -> None:
    """Check that no rule fails, each finding lies in the text and is a sentence, fixes apply."""
    text, findings = analysis.text, analysis.findings
    assert analysis.faults == ()
    for finding in findings:
        assert 0 <= finding.start <= finding.end <= len(text)
        assert finding.message and not finding.message.endswith(".")
        for related in finding.related:
            assert 0 <= related.start <= related.end <= len(text)
        if finding.fix is not None:
            apply_edits(text, finding.fix.edits)
