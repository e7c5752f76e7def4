"""Diagnostics that the client asks for."""

import itertools
import logging
from collections.abc import AsyncIterator
from typing import TYPE_CHECKING, Any, NamedTuple

from lsprotocol import types

from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.companions import companion_diagnostics
from kindsl.frontends.lsp.session.findings import SOURCE, diagnostics
from kindsl.frontends.lsp.session.progress import Progress
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.session.worker import Urgency
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.text.document import document as document_of
from kindsl.frontends.lsp.wire.client import DiagnosticParts
from kindsl.language.text.facts import Fact

if TYPE_CHECKING:
    from kindsl.judgement.analysis.diagnostics import Diagnostic
    from kindsl.judgement.analysis.settings import Settings

Report = dict[str, Any]

logger = logging.getLogger(__name__)

handlers = Handlers()

_GONE = "gone"
_SERIAL = itertools.count(1)
_OPTIONS = types.DiagnosticOptions(
    inter_file_dependencies=False, workspace_diagnostics=True, identifier=SOURCE
)

_REPORT: "Fact[_Report]" = Fact("report")
_RESULT_ID: "Fact[tuple[tuple[Diagnostic, ...], str]]" = Fact("result id")


@handlers.session(types.TEXT_DOCUMENT_DIAGNOSTIC, _OPTIONS)
async def pull(session: Session, params: types.DocumentDiagnosticParams) -> Report:
    """Answer what is wrong with a document, or that nothing has changed."""
    document = session.documents.get(params.text_document.uri)
    if document is None:
        return {"kind": "full", "items": []}
    session.publisher.leave_to_pull(document)
    if not document.is_judged:
        return {"kind": "full", "items": await companion_diagnostics(session, document)}
    version = await session.analyses.version(document)
    if not session.client.is_told_to_pull:
        findings = await version.findings()
    else:
        findings = await version.findings_without_twins(Urgency.ANSWER)
        if session.documents.is_current(document):
            findings = session.calm.shown(document, findings)
    result_id = _result_id_of(document, findings)
    if result_id == params.previous_result_id:
        return {"kind": "unchanged", "resultId": result_id}
    items = diagnostics(document, findings, session.client.shows_in_diagnostics)
    return {"kind": "full", "resultId": result_id, "items": items}


@handlers.session(types.WORKSPACE_DIAGNOSTIC)
async def pull_all(session: Session, params: types.WorkspaceDiagnosticParams) -> Report:
    """Answer what is wrong with every robot in the workspace, whether open or not.

    A client that takes partial results is told of each robot as soon as that is known. It asks
    again and again, and has its answer when there was news.
    """
    token = params.partial_result_token
    if token is None:
        return {"items": [report async for report in _workspace_reports(session, params)]}
    has_news = False
    while not has_news:
        session.news.clear()
        async for report in _workspace_reports(session, params):
            if report["kind"] == "full":
                session.editor.progress(types.ProgressParams(token, {"items": [report]}))
                has_news = True
        if not has_news:
            await session.news.wait()
    return {"items": []}


async def _workspace_reports(
    session: Session, params: types.WorkspaceDiagnosticParams
) -> AsyncIterator[Report]:
    known = {uris.key(each.uri): each.value for each in params.previous_result_ids}
    listed = set()
    async with Progress(session, "Checking robots", params.work_done_token) as progress:
        robots = await session.open_and_closed()
        async for report in progress.over(
            robots, lambda uri: _workspace_report(session, uri, known)
        ):
            if report is not None:
                listed.add(uris.key(report["uri"]))
                yield report
    for each in params.previous_result_ids:
        if uris.key(each.uri) not in listed:
            yield _gone_report(each)


def _gone_report(previous: types.PreviousResultId) -> Report:
    told = {"uri": previous.uri, "version": None, "resultId": _GONE}
    if previous.value == _GONE:
        return {**told, "kind": "unchanged"}
    return {**told, "kind": "full", "items": []}


async def _workspace_report(session: Session, uri: str, known: dict[str, str]) -> Report | None:
    document = session.documents.get(uri)
    if document is None or not document.is_robot:
        return None
    report = await _report(session, document)
    told = {"uri": uri, "version": document.version, "resultId": report.result_id}
    if report.result_id == known.get(uris.key(uri)):
        return {**told, "kind": "unchanged"}
    return {**told, "kind": "full", "items": report.items}


async def _report(session: Session, document: Document) -> "_Report":
    """Return the findings of a document; of a closed file only this report is kept."""
    version = await session.analyses.version(document)
    settings = version.settings
    report = document.facts.get(_REPORT)
    if report is None or report.settings != settings:
        parts = session.client.shows_in_diagnostics
        if document.version is None:
            told = document.uri, document.text, document.encoding
            items, faults = await session.helper.run(_checked, *told, settings, parts)
            for fault in faults:
                logger.error("a rule failed: %s", fault)
            result_id = str(next(_SERIAL))
        else:
            findings = await version.findings(Urgency.BACKGROUND)
            items = diagnostics(document, findings, parts)
            result_id = _result_id_of(document, findings)
        report = document.facts.keep(_REPORT, _Report(settings, result_id, items))
    return report


def _checked(
    uri: str, text: str, encoding: str, settings: "Settings", parts: DiagnosticParts
) -> tuple[list[dict[str, Any]], list[str]]:
    """Return the findings of a text as they are sent, and messages for the log."""
    from kindsl.judgement.analysis.analysis import Analysis

    closed = document_of(uri, None, text, encoding)
    analysis = Analysis(closed.tree, settings)
    items = diagnostics(closed, analysis.findings, parts)
    return items, [fault.message for fault in analysis.faults]


class _Report(NamedTuple):
    """The findings of a version under some settings, as they were sent."""

    settings: "Settings"
    result_id: str
    items: list[dict[str, Any]]


def _result_id_of(document: Document, findings: "tuple[Diagnostic, ...]") -> str:
    known = document.facts.get(_RESULT_ID)
    if known is None or known[0] is not findings:
        known = document.facts.keep(_RESULT_ID, (findings, str(next(_SERIAL))))
    return known[1]
