// The extension is awake in every window; a server is started for robots only.
"use strict";
const assert = require("node:assert/strict");
const { runAll, eventually, extension, open, codes, configure } = require("./harness");

exports.run = () =>
  runAll({
    "XML that is no robot starts no server": async () => {
      await open("package.xml");
      await eventually(() => extension().isActive, "activation");
      assert.equal(await extension().exports.settled(), "stopped");
    },

    "nor does a setting of the server": async () => {
      await configure("importStrategy", "fromEnvironment");
      assert.equal(await extension().exports.settled(), "stopped");
      await configure("importStrategy", undefined);
    },

    "the first robot starts it, even one that is plain text to the editor": async () => {
      const document = await open("arm.urdf");
      assert.equal(document.languageId, "plaintext");
      await eventually(() => codes(document.uri).includes("KD302"), "KD302");
      assert.equal(await extension().exports.settled(), "running");
    },
  });
