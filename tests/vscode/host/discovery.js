// What becomes of a missing, bare, old or spoilt Python, and of a server that ends by itself.
"use strict";
const assert = require("node:assert/strict");
const vscode = require("vscode");
const { runAll, eventually, settledApi, fileUri, open, readJson, messages, codes, set, configure } = require("./harness");

exports.run = async () => {
  const places = await readJson("interpreters.json");
  const { uri } = await open("broken.kindsl");
  const api = await settledApi();

  /** The problems that a change of a setting brings. */
  const problemsOf = async (change) => {
    const before = api.problems.length;
    await change();
    return api.problems.slice(before);
  };

  await runAll({
    "a setting that names no Python: one message that names the setting": async () => {
      const problems = await problemsOf(() => configure("interpreter", ["/nowhere/python3"]));
      assert.equal(await api.settled(), "failed");
      assert.deepEqual(problems, [{ kind: "noInterpreter", rejected: ["/nowhere/python3: not found"] }]);
    },

    "no Python: the document is still one of the language": async () => {
      assert.equal((await vscode.workspace.openTextDocument(uri)).languageId, "kinematics-dsl");
    },

    "an old Python is told from none": async () => {
      const problems = await problemsOf(() => configure("interpreter", [places.old]));
      assert.equal(problems.length, 1);
      assert.match(problems[0].rejected[0], /Python 3\.8\.10 is too old$/);
    },

    "Python without any package: no message, and the findings come": async () => {
      const problems = await problemsOf(() => configure("interpreter", [places.bare]));
      assert.equal(await api.settled(), "running");
      assert.deepEqual(problems, []);
      await eventually(() => codes(uri).includes("KD106"), "KD106");
    },

    "Python without any package: completion works": async () => {
      const place = new vscode.Position(3, 5);
      const list = await vscode.commands.executeCommand("vscode.executeCompletionItemProvider", uri, place);
      assert.ok(list.items.length > 0);
    },

    "an old pygls in the environment does not win": async () => {
      await configure("interpreter", [places.spoilt]);
      assert.equal(await api.settled(), "running");
      await eventually(() => codes(uri).includes("KD106"), "KD106");
    },

    "an old pygls that is asked for is reported once": async () => {
      const problems = await problemsOf(() => configure("importStrategy", "fromEnvironment"));
      assert.equal(await api.settled(), "failed");
      assert.deepEqual(problems.map(({ kind }) => kind), ["startFailed"]);
      await configure("importStrategy", undefined);
    },

    "libraries of a good environment may be asked for": async () => {
      await configure("interpreter", [places.good]);
      await configure("importStrategy", "fromEnvironment");
      assert.equal(await api.settled(), "running");
      await configure("importStrategy", undefined);
    },

    "what is typed into a new robot before the server runs stays as it is": async () => {
      await set("interpreter", [places.held]);
      const made = vscode.commands.executeCommand("kindsl.newFile");
      const isNew = (editor) => editor?.document.isUntitled;
      await eventually(() => isNew(vscode.window.activeTextEditor), "a new document");
      const { document } = vscode.window.activeTextEditor;
      const edit = new vscode.WorkspaceEdit();
      edit.insert(document.uri, new vscode.Position(0, 0), "Robot mine {");
      await vscode.workspace.applyEdit(edit);
      await vscode.workspace.fs.writeFile(fileUri("may-run"), new Uint8Array());
      await made;
      assert.equal(document.getText(), "Robot mine {");
      await vscode.commands.executeCommand("workbench.action.revertAndCloseActiveEditor");
      await configure("interpreter", [places.good]);
    },

    "a completion that is asked for before the server runs is answered": async () => {
      await vscode.workspace.fs.delete(fileUri("may-run"));
      await set("interpreter", [places.held]);
      const place = new vscode.Position(3, 5);
      const asked = vscode.commands.executeCommand("vscode.executeCompletionItemProvider", uri, place);
      const first = await Promise.race([asked, new Promise((resolve) => setTimeout(resolve, 300, "waits"))]);
      assert.equal(first, "waits");
      await vscode.workspace.fs.writeFile(fileUri("may-run"), new Uint8Array());
      assert.ok((await asked).items.some(({ insertText }) => insertText !== undefined));
      await configure("interpreter", [places.good]);
      const again = await vscode.commands.executeCommand("vscode.executeCompletionItemProvider", uri, place);
      const labels = again.items.map(({ label }) => label.label ?? label);
      assert.equal(new Set(labels).size, labels.length, "each once");
    },

    "the built-in Python may be asked for": async () => {
      const problems = await problemsOf(() => configure("interpreter", ["built-in"]));
      assert.equal(await api.settled(), "running");
      assert.equal(api.isBuiltIn(), true);
      assert.equal(api.interpreter(), undefined);
      assert.deepEqual(problems, []);
      await eventually(() => codes(uri).includes("KD106"), "KD106");
      await configure("interpreter", [places.good]);
      assert.equal(api.isBuiltIn(), false);
    },

    "a server of one's own": async () => {
      await configure("path", [places.good, places.stub]);
      assert.equal(await api.settled(), "running");
      assert.equal(api.interpreter(), undefined);
      await eventually(() => codes(uri).includes("STUB"), "a finding of the stub");
    },

    "a server that ends by itself is started again": async () => {
      const problems = await problemsOf(async () => {
        const first = messages(uri);
        await vscode.commands.executeCommand("stub.crash").then(undefined, () => undefined);
        await eventually(() => messages(uri) !== first, "a finding of another process");
      });
      assert.deepEqual(problems, []);
    },

    "a server that ends again and again is left alone, with one message": async () => {
      const problems = await problemsOf(async () => {
        await configure("path", [places.good, places.stub, "--crash-when-initialized"]);
        await eventually(async () => (await api.settled()) === "failed", "giving up");
      });
      assert.equal(problems.length, 1);
      await configure("path", undefined);
      assert.equal(await api.settled(), "running");
    },
  });
};
