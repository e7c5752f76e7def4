"""Documents, mechanisms and findings in notebooks: HTML without remote addresses."""

from html import escape

from kindsl.frontends.preview.export import exported_page
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Findings
from kindsl.language.text.lines import LineIndex
from kindsl.language.text.phrases import counted, listed
from kindsl.products.reports.card import card_page
from kindsl.products.reports.drawing.robot import robot_drawing
from kindsl.products.reports.drawing.svg import svg_text
from kindsl.products.reports.page.blocks import Figure
from kindsl.robots.mechanism.build import Mechanism
from kindsl.robots.scene.formulas import formula_messages

_HEIGHT = 480  # pixels
_MOST = 50  # findings
_STYLE = "width: 100%; border: 1px solid #8884; border-radius: 8px;"
_COLORS = {"error": "#c0392b", "warning": "#b8860b", "info": "#2b6cb0", "hint": "#6b7280"}


def notebook_html(thing: object) -> str | None:
    """Return a document, mechanism or findings as HTML, None for anything else."""
    if isinstance(thing, Analysis):
        return _document(thing)
    if isinstance(thing, Mechanism):
        return _mechanics(thing)
    return _findings(thing) if isinstance(thing, Findings) else None


def _document(analysis: Analysis) -> str:
    """Return the card's drawing; `kindsl.live` shows more."""
    pictures = (block for block in card_page(analysis) if isinstance(block, Figure))
    shown = next((svg_text(picture.drawing) for picture in pictures), "")
    return shown + (_findings(analysis.findings) if analysis.findings else "")


class LivePage:
    """A document's preview for a notebook, in a frame of its own: to turn and to move."""

    def __init__(self, document: Analysis) -> None:
        self._document = document

    def __repr__(self) -> str:
        return f"<live page of {self._document!r}>"

    def _repr_html_(self) -> str:
        title = escape(self._document.model.name or "unnamed", quote=True)
        return (
            f'<iframe sandbox="allow-scripts" title="{title}" height="{_HEIGHT}" '
            f'style="{_STYLE}" srcdoc="{escape(_preview(self._document), quote=True)}"></iframe>'
        )


def _preview(analysis: Analysis) -> str:
    from kindsl.frontends.preview.document_preview import DocumentPreview

    preview = DocumentPreview(str(analysis.model.name or "unnamed"))
    preview.show(analysis, analysis.findings)
    formulas = formula_messages(analysis.model, analysis.context.values)
    return exported_page([*preview.channel.state, *formulas])


def _mechanics(mechanics: Mechanism) -> str:
    bodies = mechanics.bodies
    base = "floating" if bodies.is_floating else "fixed"
    head = f"{base} base {bodies.base_name}, {counted(bodies.n_links, 'joint')}, "
    head += f"{mechanics.total_mass():.6g} kg"
    first = 0 if bodies.is_floating else 1
    massless = [
        name
        for name, mass in zip((bodies.base_name, *bodies.link_names), bodies.masses, strict=True)
        if not mass
    ][first:]
    head += f" ({listed(massless)} without mass)" if massless else ""
    rows = "".join(
        f"<tr><td>{i}</td><td>{escape(joint)}</td><td>{kind}</td><td>{escape(link)}</td></tr>"
        for i, (joint, kind, link) in enumerate(
            zip(bodies.joint_names, bodies.joint_kinds, bodies.link_names, strict=True)
        )
    )
    return (
        f"<p>{escape(head)}</p>{svg_text(robot_drawing(mechanics.linkage))}"
        f"<details><summary>Order of q</summary><table><tr><th></th><th>joint</th><th>kind</th>"
        f"<th>link</th></tr>{rows}</table></details>"
    )


def _findings(findings: Findings) -> str:
    """Return the findings, each with its source line and the place marked in it."""
    if not findings:
        return "<p>no findings</p>"
    lines = LineIndex(findings.text)
    shown = "".join(_finding(findings.text, lines, *f[2:6], f[0]) for f in findings[:_MOST])
    left = len(findings) - _MOST
    more = f"<p>and {left} more</p>" if left > 0 else ""
    return f"<div>{shown}</div>{more}"


def _finding(
    text: str, lines: LineIndex, severity: str, message: str, start: int, end: int, code: str
) -> str:
    line, column = lines.position(start)
    first = start - column
    last = min(x for x in (text.find("\n", start), len(text)) if x >= 0)
    end = max(min(end, last), start)
    marked = (
        f"{escape(text[first:start])}<mark>{escape(text[start:end])}</mark>{escape(text[end:last])}"
    )
    place = f'<code style="opacity: 0.6">{line + 1}:{column + 1}</code>'
    tag = f'<b style="color: {_COLORS[str(severity)]}">{escape(str(severity))} {code}</b>'
    return f"<p>{place} {tag} {escape(message)}<br><code><pre>{marked}</pre></code></p>"
