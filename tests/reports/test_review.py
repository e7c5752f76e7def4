"""`kindsl review` names every planted edit, and shows broken documents as far as they go."""

import re
import subprocess
from pathlib import Path

import pytest
from tests.reports.planted_edits import EDITS, TEXT, planted

import kindsl
from kindsl.frontends.cli.main import main
from kindsl.judgement.analysis.settings import Settings
from kindsl.products.reports.drawing.shapes import Label, Line
from kindsl.products.reports.page.blocks import Heading, Page, Paragraph, SideBySide, Table
from kindsl.products.reports.review.files import review_files
from kindsl.products.reports.review.page import HEAVIER, MOVED, review_page


def page(old: str, new: str) -> Page:
    before, after = (kindsl.parse(text, Settings()) for text in (old, new))
    return review_page(before, after, ("old", "new"))


def rows(blocks: Page, title: str) -> list[tuple[str, ...]]:
    for i, block in enumerate(blocks):
        if isinstance(block, Heading) and block.text == title:
            table = blocks[i + 1]
            return list(table.rows) if isinstance(table, Table) else []
    return []


@pytest.mark.parametrize("edit", EDITS, ids=lambda edit: edit.__name__)
def test_planted_edit_is_named(edit) -> None:
    there = planted(edit, seed=len(edit.__name__))
    blocks = page(TEXT, there.text)
    changes = rows(blocks, "What changed")
    for kind, name, part in there.changes:
        assert any(r[:2] == (kind, name) and part in r[2] for r in changes), changes
    numbers = [(r[1], r[2], r[5]) for r in rows(blocks, "Numbers")]
    assert sorted(numbers) == sorted(there.numbers)


@pytest.mark.parametrize("mass", ["", "0.634 *", "x"])
def test_a_mass_that_cannot_be_read_changes_no_total(mass: str) -> None:
    blocks = page(TEXT, TEXT.replace("mass = 0.634", f"mass = {mass}", 1))
    assert not [row for row in rows(blocks, "What changed") if row[0] in ("total", "inertia")]
    said = [block.text for block in blocks if isinstance(block, Paragraph)]
    assert [text for text in said if "left out" in text]
    assert Heading("Balance at zero") not in blocks


def test_nothing_changed_is_said() -> None:
    blocks = page(TEXT, TEXT.replace("mass = 3.3\n", "mass = 3.30 // the same\n"))
    assert Paragraph("Nothing changed mechanically.") in blocks
    assert not rows(blocks, "Numbers")


def test_what_moved_has_a_colour_and_the_camera_stays() -> None:
    blocks = page(TEXT, TEXT.replace("mass = 0.634", "mass = 0.7", 1).replace("0.209", "0.3", 1))
    (side,) = (block for block in blocks if isinstance(block, SideBySide))
    assert [picture.name for picture in side.pictures] == ["before", "after"]
    for picture in side.pictures:
        colors = {shape.color for shape in picture.drawing.shapes if isinstance(shape, Line)}
        assert {MOVED, HEAVIER} <= colors
    places = [
        {s.text: s.place for s in picture.drawing.shapes if isinstance(s, Label)}
        for picture in side.pictures
    ]
    assert places[0]["RH_foot"] == places[1]["RH_foot"] != places[1]["LF_foot"]


def test_balance_shifts_with_a_mass() -> None:
    blocks = page(TEXT, TEXT.replace("mass = 3.3\n", "mass = 6.6\n"))
    assert any(isinstance(b, Paragraph) and "shifts by" in b.text for b in blocks)
    blocks = page(TEXT, TEXT.replace("CoM = (0.0, 0.02, 0.016)", "CoM = (0.1, 0.02, 0.016)", 1))
    balance = next(i for i, b in enumerate(blocks) if b == Heading("Balance at zero"))
    table = next(b for b in blocks[balance:] if isinstance(b, Table))
    shifts = {row[0]: row[3] for row in table.rows}
    assert shifts["LF_HFE"] and not shifts["RH_HFE"]


def test_findings_are_new_gone_or_kept() -> None:
    bad = TEXT.replace("mass = 3.3\n", "mass = -3.3\n")
    for old, new, told in ((TEXT, bad, "New"), (bad, TEXT, "Gone"), (bad, "\n" + bad, "Kept")):
        found = [row[2] for row in rows(page(old, new), told)]
        assert "KD303" in found, told


@pytest.mark.parametrize("cut", [0, 30, 700, 3000])
@pytest.mark.parametrize("turn", ["old", "new"])
def test_broken_on_one_side_is_shown_as_far_as_it_goes(cut: int, turn: str) -> None:
    texts = (TEXT[:cut], TEXT) if turn == "old" else (TEXT, TEXT[:cut])
    blocks = page(*texts)
    said = ("showing the rest", "does not describe a tree of links")
    told = [b.text for b in blocks if isinstance(b, Paragraph)]
    assert any(part in text for part in said for text in told)
    files = review_files(blocks)
    assert "# " in files["review.md"] and "</html>" in files["review.html"]


def test_files_hang_together_and_need_nothing_else(tmp_path: Path) -> None:
    files = review_files(page(TEXT, TEXT.replace("0.209", "0.3", 1)))
    assert set(files) == {"review.md", "review.html", "comment.md", "before.svg", "after.svg"}
    assert re.findall(r"\]\((\w+\.svg)\)", files["review.md"]) == ["before.svg", "after.svg"]
    assert "svg" not in files["comment.md"] and "Pictures" not in files["comment.md"]
    assert "What changed" in files["comment.md"]
    assert "http" not in re.sub('xmlns="[^"]*"|http-equiv', "", files["review.html"])


def git(folder: Path, *arguments: str) -> None:
    name = ["-c", "user.name=n", "-c", "user.email=e@example.org", "-c", "commit.gpgsign=false"]
    subprocess.run(["git", "-C", folder, *name, *arguments], check=True, capture_output=True)


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    folder = tmp_path / "robots"
    folder.mkdir()
    git(folder, "init", "-b", "main")
    for text in (TEXT, TEXT.replace("0.209", "0.3", 1)):
        (folder / "quadruped.kindsl").write_text(text)
        git(folder, "add", ".")
        git(folder, "commit", "-m", "change")
    return folder


def test_two_commits_are_compared(repository: Path, tmp_path: Path) -> None:
    out, document = tmp_path / "out", str(repository / "quadruped.kindsl")
    assert main(["review", "--git", "HEAD~1..HEAD", document, "-o", str(out)]) == 0
    assert "moved" in (out / "review.md").read_text()
    assert main(["review", "--git", "HEAD~1..", document, "-o", str(out), "--force"]) == 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--git", "HEAD~7..HEAD", "quadruped.kindsl"], "'HEAD~7' is not a commit of its git"),
        (["--git", "main", "quadruped.kindsl"], "--git: error: 'main' is not BASE..HEAD"),
        (["--git", "main..--all", "quadruped.kindsl"], "is not BASE..HEAD"),
        (
            ["--git", "HEAD~1..HEAD", "absent.kindsl"],
            "absent.kindsl: error: does not exist in HEAD~1 or HEAD",
        ),
        (["--git", "HEAD~1..HEAD", "a.kindsl", "b.kindsl"], "needs one FILE with --git"),
        (["quadruped.kindsl"], "needs OLD and NEW, or --git BASE..HEAD FILE"),
        (["quadruped.kindsl", "absent.kindsl"], "absent.kindsl: error: no such file or folder"),
        (["--git", "HEAD~1..HEAD", "no/absent.kindsl"], "no such file or folder"),
        (
            ["--git", "HEAD~1..HEAD", "quadruped.kindsl", "--param", "x=1"],
            "quadruped.kindsl: error: there is no parameter 'x' in either document",
        ),
    ],
)
def test_what_cannot_be_reviewed_is_one_sentence(
    arguments: list[str], message: str, repository: Path, capsys, monkeypatch
) -> None:
    monkeypatch.chdir(repository)
    assert main(["review", *arguments, "-o", "out"]) == 2
    told = capsys.readouterr().err
    assert message in told and told.count("\n") == 1
    assert not (repository / "out").exists()


def test_folder_that_exists_stays(repository: Path, capsys, monkeypatch) -> None:
    monkeypatch.chdir(repository)
    (repository / "out").mkdir()
    arguments = ["review", "quadruped.kindsl", "quadruped.kindsl", "-o"]
    assert main([*arguments, "out"]) == 2
    assert "out: error: already exists; --force replaces" in capsys.readouterr().err
    assert main([*arguments, "quadruped.kindsl", "--force"]) == 2
    assert not list((repository / "out").iterdir())


def test_without_history_is_one_sentence(tmp_path: Path, capsys) -> None:
    document = tmp_path / "lonely" / "quadruped.kindsl"
    document.parent.mkdir()
    document.write_text(TEXT)
    assert main(["review", "--git", "a..b", str(document), "-o", str(tmp_path / "out")]) == 2
    told = capsys.readouterr().err
    assert "not a git repository" in told or "no commit" in told
