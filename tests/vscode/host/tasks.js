// The linter as a task.
"use strict";
const assert = require("node:assert/strict");
const vscode = require("vscode");
const { runAll, eventually, settledApi, fileUri, codes, configure } = require("./harness");

exports.run = () =>
  runAll({
    "there is a task for the folder": async () => {
      await settledApi();
      const tasks = await offered();
      assert.deepEqual(tasks.map(({ definition }) => definition), [{ type: "kindsl", paths: ["."] }]);
    },

    "what it finds is listed once, by the server, for files that are not open too": async () => {
      await eventually(() => codes(fileUri("broken.kindsl")).includes("KD106"), "a finding in a closed file");
      const [{ problemMatchers }] = await offered();
      assert.deepEqual(problemMatchers, []);
    },

    "the linter's task reports what the server would, by the editor's settings": reports,

    "the built-in Python runs it as well": async () => {
      const before = vscode.workspace.getConfiguration("kindsl").get("interpreter");
      const api = await configure("interpreter", ["built-in"]);
      assert.equal(api.isBuiltIn(), true);
      await reports();
      await configure("interpreter", before);
    },
  });

async function reports() {
  assert.equal(await ended(), 1);
  await configure("ignore", ["KD106"]);
  assert.equal(await ended(), 0);
  await configure("ignore", undefined);
}

/** The tasks, once there are any: a busy VS Code may say at first that there are none. */
async function offered() {
  return eventually(async () => {
    const tasks = await vscode.tasks.fetchTasks({ type: "kindsl" });
    return tasks.length > 0 ? tasks : undefined;
  }, "a task");
}

/** Run the task; what it ended with. */
async function ended() {
  const [task] = await offered();
  const end = new Promise((resolve) => vscode.tasks.onDidEndTaskProcess(({ exitCode }) => resolve(exitCode)));
  await vscode.tasks.executeTask(task);
  return end;
}
