"""docs/configuration.md shows what the reader of configurations takes."""

import re
from pathlib import Path

from kindsl.judgement.config.configuration_reading import configuration_of
from kindsl.judgement.config.schema import DOCUMENT_KEYS, KEYS

PAGE = (Path(__file__).parents[2] / "docs" / "configuration.md").read_text()


def test_example_is_right_and_shows_every_key() -> None:
    example = re.search(r"```toml\n(.*?)```", PAGE, re.DOTALL)
    assert example is not None
    configuration = configuration_of("kindsl.toml", example[1])
    assert configuration.common.bindings["l2"].maximum == 0.5
    shown = {path[0] for path in configuration.places}
    assert shown == set(KEYS)
    assert all(f"`{key}`" in PAGE or f"{key} = " in PAGE for key in DOCUMENT_KEYS)
