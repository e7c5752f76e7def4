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

  await runAll({
    "the setting wins over the Python extension": async () => {
      python.select(places.wrapped);
      assert.equal(await interpreter(), places.good);
    },

    "without a setting the Python extension's choice is used": async () => {
      await configure("interpreter", []);
      assert.equal(await interpreter(), places.wrapped);
      assert.equal(await api.settled(), "running");
    },

    "another choice is followed": async () => {
      python.select(places.good);
      await eventually(async () => (await interpreter()) === places.good, "the other interpreter");
      assert.equal(await api.settled(), "running");
    },
  });
};
