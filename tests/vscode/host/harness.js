// The least of a test runner: named tests in order, and waiting for what comes about.
"use strict";
const { isDeepStrictEqual } = require("node:util");
const vscode = require("vscode");

const TIMEOUT = 90_000;

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

/** Return what `see` gives once it is truthy. */
async function eventually(see, what) {
  const deadline = Date.now() + TIMEOUT;
  for (;;) {
    const seen = await see();
    if (seen) return seen;
    if (Date.now() > deadline) throw new Error(`not seen: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
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

/** The document in front, once `see` holds of it: VS Code tells what is in front some time after it has shown it. */
async function documentInFront(see, what) {
  const inFront = () => vscode.window.activeTextEditor?.document;
  return eventually(() => (inFront() !== undefined && see(inFront()) ? inFront() : undefined), what);
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
  documentInFront,
  fileUri,
  open,
  readJson,
  messages,
  codes,
  set,
  configure,
};
