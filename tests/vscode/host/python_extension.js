// The choice of interpreter in the Python extension.
"use strict";
const assert = require("node:assert/strict");
const vscode = require("vscode");
const { runAll, eventually, settledApi, open, readJson, configure } = require("./harness");

exports.run = async () => {
  const places = await readJson("interpreters.json");
  const python = await vscode.extensions.getExtension("ms-python.python").activate();
  await open("arm.kindsl");
  const api = await settledApi();
  const interpreter = async () => {
    await api.settled();
    return api.interpreter()?.join(" ");
  };
  // The built-in Python runs the server where another one is slow to answer; it is not asked again.
  const eventuallyUses = (place) =>
    eventually(async () => {
      const used = await interpreter();
      if (used === undefined) await vscode.commands.executeCommand("kindsl.restart");
      return used === place;
    }, `a server of ${place}`);

  await runAll({
    "the setting wins over the Python extension": async () => {
      python.select(places.wrapped);
      assert.equal(await interpreter(), places.good);
    },

    "without a setting the Python extension's choice is used": async () => {
      await configure("interpreter", []);
      await eventuallyUses(places.wrapped);
      assert.equal(await api.settled(), "running");
    },

    "another choice is followed": async () => {
      python.select(places.good);
      await eventuallyUses(places.good);
      assert.equal(await api.settled(), "running");
    },
  });
};
