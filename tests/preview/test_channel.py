"""Tabs get what changes, a new one each property once, and a stalled one costs nothing."""

import asyncio
from contextlib import suppress

from hypothesis import given
from hypothesis import strategies as st
from tests.preview.page import Page
from tests.preview.robots import plain_robot

from kindsl.frontends.preview.changes import key_of, keyed
from kindsl.frontends.preview.channel import Channel, Tab
from kindsl.frontends.preview.document_preview import DocumentPreview
from kindsl.robots.scene.messages import Change, SetObject, SetTransform, ValueMessage


class Socket:
    """A socket whose other end can stall."""

    def __init__(self):
        self.changes = []
        self.is_free = asyncio.Event()
        self.is_free.set()

    async def write(self, change):
        await self.is_free.wait()
        self.changes.append(change)

    @property
    def messages(self):
        return [part for change in self.changes for part in change.parts]


async def settle():
    for _ in range(200):
        await asyncio.sleep(0)


async def stop(task):
    task.cancel()
    with suppress(asyncio.CancelledError):
        await task


def value(name, number):
    return ValueMessage(f"/kindsl/values/{name}", name, number)


def place(name, number):
    return SetTransform(f"/kindsl/robot/{name}", (number,))


async def test_a_new_tab_gets_each_property_once():
    channel, socket = Channel(), Socket()
    for number in range(1000):
        channel.put("joints", value("a", number))
        channel.replace("robot", [place("x", number)])
    channel.join(Tab(socket.write))
    tab = next(iter(channel._tabs))
    task = asyncio.ensure_future(tab.run())
    await settle()
    await stop(task)
    assert socket.changes == [Change(True, (value("a", 999), place("x", 999)))]


async def test_what_changes_at_once_comes_at_once():
    channel, socket = Channel(), Socket()
    channel.join(Tab(socket.write))
    tab = next(iter(channel._tabs))
    task = asyncio.ensure_future(tab.run())
    await settle()
    channel.replace("robot", [place("x", 1), place("y", 2)])
    channel.announce(value("a", 3))
    await settle()
    await stop(task)
    parts = (place("x", 1), place("y", 2), value("a", 3))
    assert socket.changes == [Change(True, ()), Change(False, parts)]


async def test_a_stalled_tab_holds_one_state_and_delays_nobody():
    channel, stalled, lively = Channel(), Socket(), Socket()
    tabs = [Tab(stalled.write), Tab(lively.write)]
    for tab in tabs:
        channel.join(tab)
    tasks = [asyncio.ensure_future(tab.run()) for tab in tabs]
    await settle()
    stalled.is_free.clear()
    for number in range(2000):
        channel.put("joints", value("a", number))
        await asyncio.sleep(0)
    await settle()
    assert lively.messages[-1] == value("a", 1999)
    assert len(tabs[0]._waiting) == 1
    stalled.is_free.set()
    await settle()
    assert stalled.messages[-1] == value("a", 1999)
    assert len(stalled.messages) < 10
    for task in tasks:
        await stop(task)


async def test_the_sender_is_not_told_what_it_said():
    channel, socket = Channel(), Socket()
    tab = Tab(socket.write)
    channel.join(tab)
    channel.put("joints", value("a", 1.0), tab)
    task = asyncio.ensure_future(tab.run())
    await settle()
    await stop(task)
    assert socket.changes == [Change(True, ())]


states = st.lists(
    st.builds(
        lambda name, kind, number: kind(f"/kindsl/robot/{name}", number),
        st.sampled_from(["a", "a/b", "a/b/c", "d"]),
        st.sampled_from([SetObject, SetTransform]),
        st.integers(0, 3),
    ),
    max_size=8,
)


@given(history=st.lists(states, min_size=1, max_size=6), stalls=st.lists(st.booleans(), max_size=6))
def test_a_tab_that_stalls_at_any_time_ends_with_the_present_state(history, stalls):
    async def story():
        channel, socket = Channel(), Socket()
        tab = Tab(socket.write)
        channel.join(tab)
        task = asyncio.ensure_future(tab.run())
        for index, state in enumerate(history):
            if index < len(stalls) and stalls[index]:
                socket.is_free.clear()
            else:
                socket.is_free.set()
            channel.replace("robot", state)
            await asyncio.sleep(0)
        socket.is_free.set()
        await settle()
        await stop(task)
        return socket.messages

    assert Page(asyncio.run(story())).state == keyed(history[-1])


async def test_a_thousand_edits_leave_the_state_as_large_as_one():
    preview, robots = DocumentPreview("robot"), [plain_robot(6, seed) for seed in (1, 2)]
    preview.show(robots[0], ())
    preview.show(robots[1], ())
    first = len(preview.channel.state)
    for number in range(1000):
        preview.show(robots[number % 2], ())
        preview.set_joint("joint_1", number / 1000.0)
    keys = [key_of(message) for message in preview.channel.state]
    assert len(keys) == len(set(keys)) == first + 1
