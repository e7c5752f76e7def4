// The extension in its host: activation, settings, commands.
"use strict";
const assert = require("node:assert/strict");
const vscode = require("vscode");
const { runAll, eventually, extension, settledApi, shownBy, open, codes, configure } = require("./harness");

const BROKEN = "broken.kindsl";
const URDF = `<robot name="pan"><link name="base"/><link name="head"/>
<joint name="turn" type="continuous"><parent link="base"/><child link="head"/><axis xyz="0 0 1"/></joint></robot>`;
const SDF = `<sdf version="1.9"><model name="tilt"><link name="base"/><link name="head"/>
<joint name="turn" type="revolute"><parent>base</parent><child>head</child><axis><xyz>0 0 1</xyz></axis></joint></model></sdf>`;

exports.run = () =>
  runAll({
    "sleeps until there is a document": () => {
      assert.equal(extension().isActive, false);
    },

    "a document of the language wakes it": async () => {
      const document = await open("arm.kindsl");
      assert.equal(document.languageId, "kinematics-dsl");
      await eventually(() => extension().isActive, "activation");
      const api = await settledApi();
      assert.equal(await api.settled(), "running");
      assert.deepEqual(api.problems, []);
    },

    "runs in the configured interpreter": async () => {
      const configured = vscode.workspace.getConfiguration("kindsl").get("interpreter");
      assert.deepEqual((await settledApi()).interpreter(), configured);
    },

    "all its commands are there": async () => {
      const known = new Set(await vscode.commands.getCommands(true));
      const promised = extension().packageJSON.contributes.commands.map(({ command }) => command);
      assert.deepEqual(promised.filter((command) => !known.has(command)), []);
    },

    "the server's findings arrive": async () => {
      const { uri } = await open(BROKEN);
      await eventually(() => codes(uri).includes("KD106"), "KD106");
    },

    "a clean document has no errors": async () => {
      const { uri } = await open("arm.kindsl");
      await eventually(async () => (await symbols(uri)).length > 0, "an outline");
      const errors = vscode.languages.getDiagnostics(uri).filter(({ severity }) => severity === 0);
      assert.deepEqual(errors, []);
    },

    "a setting of the language takes effect without a restart": async () => {
      const { uri } = await open(BROKEN);
      await configure("ignore", ["KD106"]);
      await eventually(() => codes(uri).length > 0 && !codes(uri).includes("KD106"), "KD106 gone");
      await configure("ignore", undefined);
      await eventually(() => codes(uri).includes("KD106"), "KD106 back");
    },

    "a number that is set is undone by one step": async () => {
      const document = await open("arm.kindsl"), before = document.getText();
      const number = { kind: "joint", name: "elbow", component: "x", value: 0.55, step: null };
      const answer = await vscode.commands.executeCommand("kindsl.setComponent", document.uri.toString(), number);
      assert.equal(answer.reason, null);
      await eventually(() => document.getText() !== before, "the number");
      assert.equal(document.getText(), before.replace("(0.4, 0.0", "(0.55, 0.0"));
      await vscode.commands.executeCommand("undo");
      await eventually(() => document.getText() === before, "the number as it was");
      await document.save();
    },

    "a restart brings the findings back": async () => {
      const { uri } = await open(BROKEN);
      await vscode.commands.executeCommand("kindsl.restart");
      assert.equal(await (await settledApi()).settled(), "running");
      await eventually(() => codes(uri).includes("KD106"), "KD106");
    },

    "two restarts at once leave one server": async () => {
      const restart = () => vscode.commands.executeCommand("kindsl.restart");
      await Promise.all([restart(), restart(), restart()]);
      assert.equal(await (await settledApi()).settled(), "running");
    },

    "an untitled document is served": async () => {
      const isNew = (it) => /^Robot Name \{\n\nRobotBase base \{/.test(it.getText());
      const document = await shownBy(["kindsl.newFile"], isNew, "a new robot");
      assert.equal(document.uri.scheme, "untitled");
      assert.equal(document.languageId, "kinematics-dsl");
      const edit = new vscode.WorkspaceEdit();
      assert.deepEqual(codes(document.uri), []);
      edit.insert(document.uri, new vscode.Position(0, 0), "Robot r { RobotBase b { } nonsense }");
      await vscode.workspace.applyEdit(edit);
      await eventually(() => codes(document.uri).length > 0, "findings in the untitled document");
      await vscode.commands.executeCommand("workbench.action.revertAndCloseActiveEditor");
    },

    "a robot of another format becomes a new document": async () => {
      for (const [name, content] of Object.entries({ "pan.urdf": URDF, "tilt.sdf": SDF })) {
        const uri = vscode.Uri.joinPath(vscode.workspace.workspaceFolders[0].uri, name);
        await vscode.workspace.fs.writeFile(uri, new TextEncoder().encode(content));
        const robot = `Robot ${name.split(".")[0]} {`;
        const isRobot = (it) => it.getText().startsWith(robot) && it.getText().includes("link head {");
        const document = await shownBy(["kindsl.importFile", uri], isRobot, `the robot of ${name}`);
        assert.equal(document.uri.scheme, "untitled");
        assert.equal(document.languageId, "kinematics-dsl");
        await eventually(async () => (await symbols(document.uri)).length > 0, "an outline");
        await vscode.commands.executeCommand("workbench.action.revertAndCloseActiveEditor");
      }
    },

    "the text of an open robot counts, not the file's": async () => {
      const document = await open("pan.urdf");
      const edit = new vscode.WorkspaceEdit();
      edit.replace(document.uri, new vscode.Range(0, 0, document.lineCount, 0), URDF.replaceAll("head", "neck"));
      await vscode.workspace.applyEdit(edit);
      const isOpenOne = (it) => /link neck \{/.test(it.getText());
      await shownBy(["kindsl.importFile", document.uri], isOpenOne, "the open robot's text as a document");
    },
  });

async function symbols(uri) {
  return (await vscode.commands.executeCommand("vscode.executeDocumentSymbolProvider", uri)) ?? [];
}
