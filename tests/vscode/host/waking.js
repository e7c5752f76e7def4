// XML wakes the extension; a server is started for robots only.
"use strict";
const assert = require("node:assert/strict");
const { runAll, eventually, extension, open, codes, configure } = require("./harness");

exports.run = () =>
  runAll({
    "XML that is no robot starts no server": async () => {
      assert.equal((await open("package.xml")).languageId, "xml");
      await eventually(() => extension().isActive, "activation");
      assert.equal(await extension().exports.settled(), "stopped");
    },

    "nor does a setting of the server": async () => {
      await configure("importStrategy", "fromEnvironment");
      assert.equal(await extension().exports.settled(), "stopped");
      await configure("importStrategy", undefined);
    },

    "the first robot starts it": async () => {
      const document = await open("arm.urdf");
      assert.equal(document.languageId, "xml");
      await eventually(() => codes(document.uri).includes("KD302"), "KD302");
      assert.equal(await extension().exports.settled(), "running");
    },
  });
