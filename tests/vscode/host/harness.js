// The least of a test runner: named tests in order, and waiting for what comes about.
"use strict";
const { isDeepStrictEqual } = require("node:util");
const vscode = require("vscode");

const TIMEOUT = 90_000; // ms
const PATIENCE = 20_000; // ms

/** Run the tests in order; reject with the names of those that fail. */
async function runAll(tests) {
  const failed = [];
  for (const [name, test] of Object.entries(tests)) {
    try {
      await test();
      console.log(`TEST ok: ${name}`);
    } catch (error) {
      failed.push(name);
      console.log(`TEST FAILED: ${name}: ${error.stack ?? error}`);
    }
  }
  if (failed.length > 0) throw new Error(`failed: ${failed.join("; ")}`);
}

/** Return what `see` gives once it is truthy; do `act` first, and now and then again, as a user does whose gesture was lost. */
async function eventually(see, what, act = () => undefined) {
  const deadline = Date.now() + TIMEOUT;
  for (let due = 0; ; ) {
    if (Date.now() >= due) {
      await act();
      due = Date.now() + PATIENCE;
    }
    const seen = await see();
    if (seen) return seen;
    if (Date.now() > deadline) throw new Error(`not seen: ${what}; in front: ${inFront()?.uri}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

function inFront() {
  return vscode.window.activeTextEditor?.document;
}

function extension() {
  const found = vscode.extensions.getExtension("kindsl.kindsl");
  if (found === undefined) throw new Error("the extension is not installed");
  return found;
}

/** What the extension exports, once its server has settled. */
async function settledApi() {
  const api = await extension().activate();
  await api.settled();
  return api;
}

/** The document that a command shows, once `see` holds of what is in front: VS Code tells that some time after. */
async function shownBy(command, see, what) {
  const run = () => vscode.commands.executeCommand(...command);
  return eventually(() => (inFront() !== undefined && see(inFront()) ? inFront() : undefined), what, run);
}

function fileUri(name) {
  return vscode.Uri.joinPath(vscode.workspace.workspaceFolders[0].uri, name);
}

async function open(name) {
  const document = await vscode.workspace.openTextDocument(fileUri(name));
  await vscode.window.showTextDocument(document);
  return document;
}

async function readJson(name) {
  return JSON.parse(new TextDecoder().decode(await vscode.workspace.fs.readFile(fileUri(name))));
}

/** The messages of a document's findings, in one line. */
function messages(uri) {
  return vscode.languages.getDiagnostics(uri).map(({ message }) => message).join("; ");
}

function codes(uri) {
  return vscode.languages
    .getDiagnostics(uri)
    .map(({ code }) => (typeof code === "object" ? code.value : code))
    .filter(Boolean);
}

/** Change a setting of the user's and wait until the extension was told. */
async function set(key, value) {
  const inspected = () => vscode.workspace.getConfiguration("kindsl").inspect(key).globalValue;
  await vscode.workspace.getConfiguration("kindsl").update(key, value, vscode.ConfigurationTarget.Global);
  await eventually(() => isDeepStrictEqual(inspected(), value), `the setting ${key}`);
}

/** Change a setting of the user's and wait until the server has settled again. */
async function configure(key, value) {
  await set(key, value);
  return settledApi();
}

module.exports = {
  runAll,
  eventually,
  extension,
  settledApi,
  shownBy,
  fileUri,
  open,
  readJson,
  messages,
  codes,
  set,
  configure,
};
