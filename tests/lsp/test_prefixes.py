"""Half-typed documents: every kind of request on prefixes of each example, never an error.

The steps here are prime, so that all kinds of places are met; `benchmarks/soak.py --prefixes`
takes every prefix.
"""

from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.support.lsp import RawClient, ready_client
from tests.support.lsp_requests import every_request, place_of

EXAMPLES = sorted(Path(__file__).parents[2].joinpath("examples").glob("*.kindsl"))
STEP = 53
UTF32 = {"general": {"positionEncodings": ["utf-32"]}}


@pytest.fixture(scope="module")
def client() -> Iterator[RawClient]:
    with ready_client(UTF32) as client:
        yield client


def test_there_are_examples() -> None:
    assert EXAMPLES


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_no_request_on_a_prefix_is_an_error(client: RawClient, example: Path) -> None:
    text = example.read_text(encoding="utf-8")
    uri = f"untitled:{example.stem}"
    client.open(uri, "")
    for version, end in enumerate(range(STEP // 2, len(text), STEP), 2):
        client.change(uri, version, {"text": text[:end]})
        asked = {
            client.start(method, params): method
            for method, params in every_request(uri, place_of(text, end))
        }
        for msg_id, method in asked.items():
            assert "error" not in client.answer(msg_id), (method, text[:end][-80:])
        client.messages.clear()
    client.close(uri)
