"""A URDF in a real VS Code, whatever language the editor takes it for."""

from playwright.sync_api import expect
from tests.analysis.test_urdf_fixes import LEGS, spoilt
from tests.vscode.workbench import Workbench

MOMENT = 'iyy="0.0046023457"'


def test_a_urdf_is_underlined_explained_and_fixed(workbench: Workbench) -> None:
    path = workbench.open("legs.urdf", spoilt(MOMENT, MOMENT.replace('"0', '"-0')))
    expect(workbench.squiggles("error")).to_have_count(1)
    expect(workbench.problems().filter(has_text="KD301")).to_contain_text("'left_thigh'")
    workbench.hide_panel()
    workbench.go_to('link name="left_thigh"', path)
    workbench.hover("carried by joint left_hip")
    workbench.screenshot("urdf")
    workbench.press("Escape")
    workbench.go_to("<inertial>", path, 1)
    fix = workbench.fixes("Change sign of iyy").and_(workbench.page.locator(".focused"))
    expect(fix).to_be_visible()
    workbench.press("Enter")
    expect(workbench.squiggles("error")).to_have_count(0)
    assert workbench.text_of(path) == LEGS
