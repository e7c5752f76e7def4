"""Things that share what should tell them apart."""

from kindsl.judgement.rules.duplicates import repeats


def test_things_repeat_what_the_first_of_their_kind_has() -> None:
    words = ["arm", "leg", "", "Arm", "", "ARM", "hand"]
    assert repeats(words, str.lower) == [("arm", "Arm"), ("arm", "ARM")]
    assert repeats([1, 2, 3], lambda _: None) == []
