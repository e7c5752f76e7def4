"""What is sent makes the page show the new state, and nothing is sent twice."""

from hypothesis import given
from hypothesis import strategies as st
from tests.preview.page import Page

from kindsl.frontends.preview.changes import changes, keyed
from kindsl.robots.scene.messages import Delete, SetObject, SetTransform, ValueMessage, path_of


def _value(path, number):
    return ValueMessage(path, "a", number)


elements = st.sampled_from(["a", "b", "c/d", "links", "ü"])
paths = st.lists(elements, min_size=1, max_size=4).map(lambda names: path_of("robot", *names))
messages = st.builds(
    lambda path, kind, value: kind(path, value),
    paths,
    st.sampled_from([SetObject, SetTransform, _value]),
    st.integers(0, 3),
)
states = st.lists(messages, max_size=20).map(keyed)


@given(old=states, new=states)
def test_changes_lead_from_any_state_to_any_other(old, new):
    page = Page(old.values())
    for message in changes(old, new):
        page.take(message)
    assert page.state == new


@given(old=states)
def test_no_change_sends_nothing(old):
    assert changes(old, dict(old)) == []


@given(old=states, more=states)
def test_what_stays_is_not_sent_again(old, more):
    sent = changes(old, old | more)
    assert keyed(sent) == {key: m for key, m in more.items() if old.get(key) != m}


def test_a_whole_branch_is_deleted_at_once():
    old = keyed(SetTransform(path_of("robot", "links", "a", str(i)), ()) for i in range(5))
    keep = SetTransform(path_of("robot", "links", "b"), ())
    assert changes(old | keyed([keep]), keyed([keep])) == [Delete("/kindsl/robot/links/a")]


def test_a_name_cannot_leave_its_place():
    assert path_of("robot", "../x/y") == "/kindsl/robot/..%2Fx%2Fy"
