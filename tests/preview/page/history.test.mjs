import assert from "node:assert/strict";
import test from "node:test";
import { element, makeRandom } from "./stage.mjs";
import { History } from "../../../server/kindsl/frontends/preview/page/history.js";

const REST = 1000; // milliseconds, more than a pause makes a step

function begun(t, now = "0") {
  t.mock.timers.enable({ apis: ["setTimeout"] });
  const world = { now, planned: [] };
  const editing = { afterwards: (act) => act(), plan: (which) => world.planned.push(which) };
  const history = new History(() => world.now, (state) => { world.now = state; }, editing);
  history.begin();
  const become = (state) => {
    world.now = state;
    history.note();
  };
  return { world, history, become, rest: () => t.mock.timers.tick(REST) };
}

test("a pause makes a step, and each step is undone and done again", (t) => {
  const { world, history, become, rest } = begun(t);
  become("1");
  become("2");
  rest();
  become("3");
  rest();
  history.undo();
  assert.equal(world.now, "2");
  history.undo();
  assert.equal(world.now, "0");
  assert.equal(element("#undo").disabled, true);
  history.redo();
  assert.equal(world.now, "2");
});

test("undoing takes what has not come to rest with it", (t) => {
  const { world, history, become } = begun(t);
  become("1");
  history.undo();
  assert.equal(world.now, "0");
  history.redo();
  assert.equal(world.now, "1");
});

test("any order of steps ends where a list of states says", (t) => {
  const { world, history, become, rest } = begun(t);
  const random = makeRandom(11);
  let states = ["0"], at = 0;
  for (let i = 1; i < 500; i++) {
    const choice = random();
    if (choice < 0.5) {
      become(String(i));
      rest();
      states = [...states.slice(0, at + 1), String(i)].slice(-201);
      at = states.length - 1;
    } else if (choice < 0.8) {
      history.undo();
      at = Math.max(0, at - 1);
    } else {
      history.redo();
      at = Math.min(states.length - 1, at + 1);
    }
    assert.equal(world.now, states[at]);
    assert.equal(element("#redo").disabled, at === states.length - 1);
  }
});

test("what had not come to rest when something was written is a step before it", (t) => {
  const { world, history, become } = begun(t);
  become("1");
  history.wrote();
  history.undo();
  history.rewritten("undo", true);
  assert.equal(world.now, "1");
  history.undo();
  assert.equal(world.now, "0");
});

test("the last 200 steps can be undone", (t) => {
  const { world, history, become, rest } = begun(t);
  for (let i = 1; i <= 250; i++) {
    become(String(i));
    rest();
  }
  for (let i = 0; i < 250; i++) history.undo();
  assert.equal(world.now, "50");
});

test("what was written is asked to be taken back, in its order", (t) => {
  const { world, history, become, rest } = begun(t);
  become("1");
  rest();
  history.wrote();
  become("2");
  rest();
  history.undo();
  history.undo();
  assert.deepEqual([world.now, world.planned], ["1", ["undo"]]);
  history.rewritten("undo", true);
  history.undo();
  assert.equal(world.now, "0");
  history.redo();
  history.redo();
  assert.deepEqual(world.planned, ["undo", "redo"]);
});

test("a writing that cannot be taken back is forgotten", (t) => {
  const { world, history, become, rest } = begun(t);
  become("1");
  rest();
  history.wrote();
  history.undo();
  history.rewritten("undo", false);
  history.undo();
  assert.equal(world.now, "0");
});
