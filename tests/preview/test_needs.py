"""What the preview needs is loaded when it is needed, and missed with a sentence."""

import importlib.util
import subprocess
import sys

import pytest

from kindsl.frontends.preview import assets
from kindsl.frontends.preview.assets import PreviewUnavailableError, viewer_script
from kindsl.robots.scene.geometry import Form, Shape, lowered

HEAVY = {"numpy", "tornado", "asyncio", "umsgpack", "meshcat", "IPython", "zmq", "cattrs"}


def loaded_by(statement):
    code = f"import sys; {statement}; print(*(name for name in sys.modules if '.' not in name))"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(run.stdout.split())


@pytest.mark.parametrize("module", ["kindsl.frontends.preview", "kindsl.frontends.cli.preview"])
def test_importing_it_loads_nothing_heavy(module):
    assert not loaded_by(f"import {module}") & HEAVY


def test_the_server_never_imports_meshcat_itself():
    loaded = loaded_by(
        "from kindsl.frontends.preview.server import PreviewServer;"
        "from kindsl.robots.scene.geometry import *;"
        "lowered(Shape(Form.BALL, 0))"
    )
    assert not loaded & {"meshcat", "IPython", "zmq"}


@pytest.mark.parametrize("form", Form)
def test_every_form_has_meshcats_form(form):
    thing = lowered(Shape(form, 0x123456))
    assert thing["object"]["type"] == "Mesh"
    assert thing["materials"][0]["color"] == 0x123456


def test_without_meshcat_it_says_what_to_install(monkeypatch):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    viewer_script.cache_clear()
    with pytest.raises(PreviewUnavailableError, match=r"pip install 'kindsl\[preview\]'"):
        viewer_script()
    viewer_script.cache_clear()


def test_the_viewer_comes_with_meshcat_or_is_said_to_be_missing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert viewer_script().name == "main.min.js" and viewer_script().is_file()
    monkeypatch.setattr(assets.importlib.util, "find_spec", lambda _: None)
    with pytest.raises(PreviewUnavailableError, match="needs the package 'meshcat'"):
        assets._meshcat_folder()
    spec = importlib.util.spec_from_loader("meshcat", loader=None)
    monkeypatch.setattr(assets.importlib.util, "find_spec", lambda _: spec)
    with pytest.raises(PreviewUnavailableError, match="needs the package 'meshcat'"):
        assets._meshcat_folder()


def test_an_unknown_name_is_no_part_of_it():
    import kindsl.frontends.preview

    with pytest.raises(AttributeError, match="no attribute 'Nothing'"):
        _ = kindsl.frontends.preview.Nothing
