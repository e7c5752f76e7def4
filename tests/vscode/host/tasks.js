// The linter as a task.
"use strict";
const assert = require("node:assert/strict");
const vscode = require("vscode");
const { runAll, eventually, settledApi, fileUri, codes } = require("./harness");

const BROKEN = "broken.kindsl";

exports.run = () =>
  runAll({
    "there is a task for the folder": async () => {
      await settledApi();
      const tasks = await vscode.tasks.fetchTasks({ type: "kindsl" });
      assert.deepEqual(tasks.map(({ definition }) => definition), [{ type: "kindsl", paths: ["."] }]);
    },

    "the linter's task reports through its problem matcher": async () => {
      const [task] = await vscode.tasks.fetchTasks({ type: "kindsl" });
      assert.ok(task, "a task");
      const ended = new Promise((resolve) => vscode.tasks.onDidEndTaskProcess(({ exitCode }) => resolve(exitCode)));
      await vscode.tasks.executeTask(task);
      assert.equal(await ended, 1);
      await eventually(() => codes(fileUri(BROKEN)).includes("KD106"), "a problem of the task");
    },
  });
