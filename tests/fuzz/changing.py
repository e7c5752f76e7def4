"""Random changes of an input, the same for the same seed."""

import random
from collections.abc import Sequence


def changed(data: bytes, others: Sequence[bytes], words: Sequence[bytes], seed: int) -> bytes:
    """Return an input with some of its bytes cut, doubled, replaced, or parts of others put in.

    Args:
        data: The input.
        others: Inputs to take parts from.
        words: What the target's inputs are made of.
        seed: Equal seeds give equal changes.
    """
    generator = random.Random(seed)
    for _ in range(generator.randint(1, 5)):
        start = generator.randint(0, len(data))
        end = min(len(data), start + generator.choice((0, 0, 1, 4, 30, 200)))
        data = data[:start] + _piece(generator, data, others, words) + data[end:]
    return data


def _piece(
    generator: random.Random, data: bytes, others: Sequence[bytes], words: Sequence[bytes]
) -> bytes:
    match generator.randrange(5):
        case 0:
            return b""
        case 1:
            return bytes(generator.randrange(256) for _ in range(generator.randint(1, 3)))
        case 2:
            return _part(generator, data)
        case 3:
            return _part(generator, generator.choice(others))
        case _:
            return generator.choice(words)


def _part(generator: random.Random, data: bytes) -> bytes:
    start = generator.randint(0, len(data))
    return data[start : start + generator.choice((1, 8, 60, 300))]
