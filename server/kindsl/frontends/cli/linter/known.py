"""Baselines in a run of the linter: reads and writes them, tells what is stale."""

import os
from collections.abc import Iterator, Mapping, Sequence

from kindsl.frontends.cli.documents.document_reading import CommandError
from kindsl.frontends.cli.documents.sources import is_decodable
from kindsl.frontends.cli.documents.writing import write_output
from kindsl.frontends.cli.outcome import LintedFile, RunOutcome
from kindsl.judgement.analysis.known_findings import blocks_of, identities, lines_of
from kindsl.judgement.config.baseline import baseline_path, baseline_text, path_in, read_baseline
from kindsl.judgement.config.configuration import Configuration
from kindsl.judgement.config.file_names import TRANSFORMS_SUFFIX
from kindsl.judgement.config.robots import SUFFIX
from kindsl.language.text.phrases import counted
from kindsl.robots.interchange.syntaxes import JUDGED_SUFFIXES, syntax_of


def stale_remarks(
    files: Sequence[LintedFile], configurations: Mapping[str, Configuration]
) -> Iterator[str]:
    """Yield a sentence for each baseline that knows findings that are no longer there."""
    named = {each.path: each for each in configurations.values() if each.baseline}
    for configuration in named.values():
        path = baseline_path(configuration)
        folder = os.path.dirname(os.path.abspath(path))
        own = (file for file in files if configurations.get(file.path) is configuration)
        gone = (
            sum(known.values())
            for document, known in read_baseline(configuration).items()
            if document.endswith((SUFFIX, TRANSFORMS_SUFFIX, *JUDGED_SUFFIXES))
            and not os.path.exists(os.path.join(folder, document))
        )
        number = sum(file.n_stale for file in own) + sum(gone)
        if number:
            told = "finding that is" if number == 1 else "findings that are"
            yield (
                f"{path}: warning: stale baseline: it has {number} {told} no longer there, "
                "write it anew with --write-baseline"
            )


def with_baseline_written(outcome: RunOutcome, path: str) -> RunOutcome:
    """Write what was found as known; return the outcome with it known, or with a failure."""
    decoded = (f for f in outcome.files if is_decodable(f.text) and not f.path.endswith(".toml"))
    known = {file.path: [*_identities(file)] for file in decoded}
    files = [file.with_all_known() if file.path in known else file for file in outcome.files]
    text = baseline_text({path_in(path, name): known[name] for name in known})
    try:
        write_output(path, text)
    except CommandError as error:
        return outcome._replace(failures=[*outcome.failures, *error.failures])
    remark = f"{counted(sum(map(len, known.values())), 'known finding')} written to {path}"
    return outcome._replace(files=files, remarks=[*outcome.remarks, remark])


def _identities(file: LintedFile) -> Iterator[str]:
    is_robot = not file.path.endswith(TRANSFORMS_SUFFIX)
    blocks = blocks_of(syntax_of(file.path, file.text)) if is_robot else lines_of(file.text)
    return identities(file.findings, blocks)
