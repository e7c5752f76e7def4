"""A report pasted into a link is one finding with one fix, wherever in the link it stands."""

import pytest
from tests.cad.test_reports import EXPECTED, REPORTS
from tests.cad.test_sentences import ON_AXIS
from tests.support.examples import link, robot

import kindsl
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.text_fix import TextFix
from kindsl.language.text.edits import apply_edits

LINK = """link upper {
    id = 1
%s    children {}
%s}
"""
WHOLE = """    inertia_properties {
        mass = 1.0 // weighed
        CoM = (0.0, 0.0, 0.0)
        Ix = 0.001
        Iy = 0.001
        Iz = 0.001
        Ixy = 0.0
        Ixz = 0.0
        Iyz = 0.0
%s    }
"""
PLACES = {
    "in its place": LINK % ("%s", ""),
    "behind the children": LINK % ("", "%s"),
    "before the id": (LINK % ("", "")).replace("    id", "%s    id"),
    "behind an inertia": LINK % (WHOLE % "" + "%s", ""),
    "in an inertia": LINK % (WHOLE % "%s", ""),
    "in an empty inertia": LINK % ("    inertia_properties {\n%s    }\n", ""),
}


def pasted(place: str, report: str) -> Analysis:
    text = PLACES[place].replace("%s", report.rstrip("\n") + "\n")
    return analyse(robot(text, base="upper via shoulder", joints="shoulder"))


def only(analysis: Analysis) -> Diagnostic:
    (finding,) = analysis.findings
    assert finding.code == "KD011"
    return finding


def after(analysis: Analysis, fix: TextFix | None) -> Analysis:
    assert fix is not None
    return analyse(apply_edits(analysis.text, fix.edits))


def written(analysis: Analysis) -> list[str]:
    body = analysis.model.links[0].inertia
    assert body is not None and body.mass is not None and body.com is not None
    return [e.text for e in (body.mass, *body.com.components, *body.moments.values())]


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("name", EXPECTED)
def test_one_fix_takes_it_over(name: str, place: str) -> None:
    analysis = pasted(place, REPORTS[name])
    finding = only(analysis)
    assert finding.message.startswith(f"mass properties of {EXPECTED[name]['program']}: take them")
    fixed = after(analysis, finding.fix)
    assert [f.code for f in fixed.findings if f.code != "KD508"] == []
    found = kindsl.mass_properties(REPORTS[name])
    assert written(fixed) == [found.mass, *found.com, *found.moments]
    assert ("// weighed" in fixed.text) == ("weighed" in analysis.text)


def test_an_unproved_sign_is_chosen() -> None:
    analysis = pasted("in its place", ON_AXIS.format(notation=""))
    finding = only(analysis)
    products = [written(after(analysis, fix))[7] for fix in finding.choices]
    assert finding.fix is None and products == ["0.0030", "-0.0030"]
    assert "unproved" in finding.message


def test_a_contradiction_is_told_and_not_taken_over() -> None:
    finding = only(
        pasted("in its place", ON_AXIS.format(notation="").replace("Iyx = 0", "Iyx = 1"))
    )
    assert finding.fix is None and "Ixy is 0.0030, but Iyx is 1.0030" in finding.message


def test_a_frame_that_the_report_names_is_written() -> None:
    text = LINK % ("%s", "    frames { cad { translation = (0.1, 0.0, 0.0)"
                         " rotation = (0.0, 0.0, 0.0) } }\n")  # fmt: skip
    report = REPORTS["SolidWorks_upper_arm"].replace("-- default --", "cad")
    analysis = analyse(robot(text % report, base="upper via shoulder", joints="shoulder"))
    fixed = after(analysis, only(analysis).fix)
    assert "ref_frame = cad" in fixed.text


def test_outside_of_links_there_is_nothing_to_write() -> None:
    text = robot(link("upper", 1), base="upper via shoulder", joints="shoulder")
    report = REPORTS["SolidWorks_upper_arm"]
    finding = only(analyse(text.replace("r_joint", f"{report}\nr_joint")))
    assert finding.fix is None and finding.message.endswith("belong in a link")


def test_line_ends_are_kept() -> None:
    text = pasted("behind the children", REPORTS["SolidWorks_upper_arm"]).text
    analysis = analyse(text.replace("\n", "\r\n"))
    fixed = after(analysis, only(analysis).fix)
    assert fixed.text.count("\n") == fixed.text.count("\r\n")


def test_comments_are_no_report() -> None:
    lines = "".join(f"// {line}\n" for line in REPORTS["Creo_hip"].splitlines())
    assert "KD011" not in [finding.code for finding in pasted("in its place", lines).findings]
