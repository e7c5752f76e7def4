"""Which version of a file `kindsl preview` shows while findings of an older one are awaited."""

import asyncio
import threading

from tests.preview.robots import ARM

from kindsl.frontends.preview import command
from kindsl.frontends.preview.document_preview import DocumentPreview
from kindsl.frontends.preview.watch import fingerprint
from kindsl.judgement.analysis.analysis import Analysis, analyse


class Recorder:
    """A server that notes what it is to show."""

    def __init__(self, *_, **__):
        self.shown = []

    async def show(self, _, analysis, findings=None):
        self.shown.append((analysis, findings))

    def at(self, _):
        return DocumentPreview("arm")


async def test_findings_of_an_older_version_do_not_bring_it_back(monkeypatch, tmp_path):
    file = str(tmp_path / "arm.kindsl")
    old, new = analyse(ARM), analyse(ARM.replace("(0.4, 0.0", "(0.6, 0.0"))
    may_find = threading.Event()

    def findings(analysis):
        if analysis is old:
            may_find.wait()
        return ()

    monkeypatch.setattr(Analysis, "findings", property(findings))
    monkeypatch.setattr(command, "PreviewServer", Recorder)
    follower = command._Follower(
        command.Command(
            file, lambda: new, old, lambda _: None, 0, False, (file,), fingerprint([file]), str
        )
    )
    showing = asyncio.ensure_future(follower.show(old))
    while not follower.server.shown:
        await asyncio.sleep(0)
    await follower.show(new)
    may_find.set()
    await showing
    assert follower.server.shown == [(old, None), (new, None), (new, ())]
