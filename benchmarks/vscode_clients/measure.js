// Milliseconds from the call of activate() until the server has answered `initialize`.
"use strict";
const vscode = require("vscode");

const SUBJECTS = {
  kindsl: async () => {
    const api = await vscode.extensions.getExtension("kindsl.kindsl").activate();
    if ((await api.settled()) !== "running") throw new Error("the server does not run");
  },
  minimal: () => vscode.extensions.getExtension("kindsl-benchmarks.minimal").activate(),
};

exports.run = async () => {
  const name = vscode.workspace.workspaceFolders[0].name;
  const start = performance.now();
  await SUBJECTS[name]();
  console.log(`TEST ${name} ${performance.now() - start}`);
};
