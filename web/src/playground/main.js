// The playground: editor, problems, kinematic tree and live preview, all in this tab.
import * as monaco from "monaco-editor/editor/editor.api.js";
import "monaco-editor/features/register.all.js";
import { MonacoLspClient, createTransportToWorker } from "../../node_modules/monaco-editor/esm/external/monaco-lsp-client/out/index.js";
import { byId, debounced } from "./elements.js";
import { CONFIGURATION, Files, nameOf, properName, uriOf } from "./files.js";
import { registerLanguage } from "./language.js";
import { Notice } from "./notice.js";
import { Outline } from "./outline.js";
import { rangeOf } from "./places.js";
import { Preview } from "./preview.js";
import { Problems } from "./problems.js";
import { ServerPort } from "./server_port.js";
import { sizeProblem } from "./sizes.js";
import { fromFragment, toFragment } from "./share.js";
import { Comparison } from "./comparison.js";
import { Keeping, keyOf, storeOf } from "./keeping.js";

/** @typedef {{ readonly range: Range, readonly newText: string }} TextEdit */
/** @typedef {{ readonly textDocument: { readonly uri: string, readonly version?: number | null }, readonly edits: readonly TextEdit[] }} DocumentEdit */
/** @typedef {{ readonly changes?: Readonly<Record<string, readonly TextEdit[]>>, readonly documentChanges?: readonly DocumentEdit[] }} WorkspaceEdit */
/** @import { Range } from "./places.js" */

const FIRST = "quadruped";
const CHANGED = 2, DELETED = 3; // of the protocol
const OF_OTHERS = /\.(urdf|sdf|xacro|mjcf|xml)$/i;
const NEW_ROBOT = `Robot my_robot {

    RobotBase base {
        children { }
    }
}
`;

self.MonacoEnvironment = { getWorker: () => new Worker("editor.worker.js") };
registerLanguage();
const dark = matchMedia("(prefers-color-scheme: dark)");
const editor = monaco.editor.create(byId("editor"), {
  model: null, theme: themeName(), automaticLayout: true, minimap: { enabled: false }, scrollBeyondLastLine: false,
  "semanticHighlighting.enabled": true, inlayHints: { enabled: "on" }, wordBasedSuggestions: "off", fixedOverflowWidgets: true,
  lineNumbersMinChars: 4,
});
// A phone, where long lines are to be read.
const narrow = matchMedia("(max-width: 760px)");
const wrap = () => editor.updateOptions({ wordWrap: narrow.matches ? "on" : "off" });
narrow.addEventListener("change", wrap);
wrap();
const query = new URLSearchParams(location.search);
const port = new ServerPort(new Worker("server/worker.js"), new URL("server/", location.href).href, { useImage: query.get("image") !== "off", tellsProgress: true });
const files = new Files(editor, byId("tabs"));
const preview = new Preview(byId("preview"), port);
const comparison = new Comparison(byId("comparison"), byId("editor"), files, port);
const notice = new Notice(byId("notice"));
new Outline(byId("outline"), editor, port);
const problems = new Problems(byId("problems"), byId("problem-count"), editor, port);

files.onActive = (/** @type {string} */ name) => {
  comparison.hide();
  if (name.endsWith(".kindsl")) void preview.show(name).catch((error) => say(error.message));
};
files.onChange = (/** @type {string} */ name) => {
  if (name === CONFIGURATION) writeConfiguration();
  comparison.refresh();
  keepSoon();
};

files.onClose = (/** @type {string} */ name) => {
  // What is compared may be gone, and what is offered is.
  comparison.hide();
  if (name === CONFIGURATION) writeConfiguration();
  offerAgain(name);
  keepSoon();
};

const writeConfiguration = debounced(() => {
  const text = files.model(CONFIGURATION)?.getValue() ?? null;
  port.notify("kindsl/writeFile", { path: `/robots/${CONFIGURATION}`, text });
  port.notify("workspace/didChangeWatchedFiles", { changes: [{ uri: uriOf(CONFIGURATION), type: text === null ? DELETED : CHANGED }] });
}, 300);

const keeping = new Keeping(storeOf(() => sessionStorage), storeOf(() => localStorage));
// Nothing is kept before everything is open and something is done with it, nor after it was thrown away.
let keptAs = "", isTouched = false;

function keep() {
  if (keptAs === "" || !isTouched) return;
  const wasKept = !keeping.hasFailed;
  keeping.write(keptAs, { active: files.active, files: files.kept(), time: Date.now() });
  if (keeping.hasFailed && wasKept) notice.tell("This browser does not keep your texts: it has no room, or forbids it. Download what you do not want to lose");
}

const keepAfterwards = debounced(keep, 300);

function keepSoon() {
  isTouched ||= keptAs !== "";
  keepAfterwards();
}

/** Open the texts that were kept for this address; return whether there were any. */
function restore() {
  const session = keeping.read(keyOf(location));
  if (session === undefined) return false;
  for (const [name, { text, original }] of Object.entries(session.files)) files.open(name, text, original);
  files.show(files.names().includes(session.active) ? session.active : files.names()[0]);
  const when = new Date(session.time).toLocaleString([], { dateStyle: "medium", timeStyle: "short" });
  notice.tell(`Restored as you left it, ${when}.`, [], { title: "Start over", act: startOver });
  return true;
}

function startOver() {
  keeping.forget(keyOf(location));
  keptAs = "";
  location.reload();
}

/**
 * Let a text that was changed and is closed be opened again.
 * @param {string} name
 */
function offerAgain(name) {
  const { text, original } = files.kept()[name];
  if (text === original) return;
  const act = () => {
    const free = files.freeName(name);
    files.open(free, text, original);
    files.show(free);
  };
  notice.tell(`${name} is closed.`, [], { title: "Open it again", act });
}

addEventListener("pagehide", keep);
document.addEventListener("visibilitychange", () => document.hidden && keep());
addEventListener("beforeunload", (event) => {
  keep();
  if (keptAs !== "" && keeping.hasFailed && files.names().some((name) => files.isChanged(name))) event.preventDefault();
});
// Another shared link in the same tab.
addEventListener("hashchange", () => location.reload());

/** @param {number} bytes */
const megabytes = (bytes) => Math.round(bytes / 1e6);

port.handlers.set("kindsl/progress", ({ loaded, total }) =>
  say(loaded < total ? `Loading Python: ${megabytes(loaded)} MB of ${megabytes(total)}` : "Starting Python…"));
port.handlers.set("kindsl/ready", ({ isImage, total }) => {
  document.body.dataset.state = "ready";
  document.body.dataset.start = `${isImage ? "image" : "zips"} ${total}`;
  say("");
});
port.handlers.set("kindsl/failed", ({ message }) => {
  problems.fail();
  say(`The language server did not start: ${message}`);
});
port.handlers.set("window/showMessage", ({ message }) => say(message));
port.handlers.set("window/logMessage", () => undefined);
port.handlers.set("workspace/configuration", ({ items }) => items.map(() => null));
port.handlers.set("window/showDocument", ({ uri, selection }) => showPlace(uri, selection));
port.handlers.set("workspace/applyEdit", ({ edit }) => ({ applied: applyEdit(edit) }));

/** @param {string} uri @param {Range} selection */
function showPlace(uri, selection) {
  const name = nameOf(uri);
  if (files.model(name) === undefined) return { success: false };
  if (files.active !== name) files.show(name);
  const range = rangeOf(selection);
  editor.setSelection(range);
  editor.revealRangeInCenterIfOutsideViewport(range);
  showPart("text");
  return { success: true };
}

/**
 * Make the server's edits, each file's as one step to undo; none if a text is not the one that they were made for.
 * @param {WorkspaceEdit} edit
 */
function applyEdit({ changes = {}, documentChanges = [] }) {
  const unversioned = Object.entries(changes).map(([uri, edits]) => ({ textDocument: { uri }, edits }));
  /** @type {readonly DocumentEdit[]} */
  const asked = [...unversioned, ...documentChanges];
  const all = asked.map(({ textDocument: { uri, version }, edits }) => ({
    model: files.model(nameOf(uri)), isCurrent: (version ?? port.version(uri)) === port.version(uri), edits,
  }));
  if (all.some(({ model, isCurrent }) => model === undefined || !isCurrent)) return false;
  for (const { model, edits } of all) {
    if (!model) continue;
    const operations = edits.map(({ range, newText }) => ({ range: rangeOf(range), text: newText }));
    model.pushStackElement();
    model.pushEditOperations(null, operations, () => null);
    model.pushStackElement();
  }
  return true;
}

/** @param {unknown} error */
const messageOf = (error) => (error instanceof Error ? error.message : String(error));

function themeName() {
  return dark.matches ? "kindsl-dark" : "kindsl-light";
}

dark.addEventListener("change", () => monaco.editor.setTheme(themeName()));

/** @param {string} text */
function say(text) {
  byId("message").textContent = text;
}

/** @returns {NodeListOf<HTMLButtonElement>} */
const partButtons = () => document.querySelectorAll("#parts button");

/** @param {string} part */
function showPart(part) {
  document.body.dataset.part = part;
  for (const button of partButtons()) button.setAttribute("aria-pressed", String(button.value === part));
}

/** @param {string} name @param {string} text */
function download(name, text) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

/** Download the robot in the active tab as URDF; what that adds to it, the server tells. */
async function downloadUrdf() {
  notice.hide();
  const name = files.active.replace(/\.\w+$/, ".urdf");
  try {
    await port.whenOpen(uriOf(files.active));
    download(name, await port.command("kindsl.exportUrdf", uriOf(files.active)));
  } catch (error) {
    notice.tell(`No URDF of ${files.active}: ${messageOf(error)}`);
  }
}

async function share() {
  const fragment = await toFragment({ active: files.active, files: files.texts() });
  history.replaceState(null, "", `${location.pathname}#${fragment}`);
  keptAs = keyOf(location);
  isTouched = true;
  keep();
  const isCopied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
  say(isCopied ? "The link is in the clipboard; it holds the texts, which were sent nowhere" : "The address holds the texts now; copy it");
}

/** @param {string} name */
async function addExample(name) {
  const file = `${name}.kindsl`;
  if (files.model(file) === undefined) {
    const text = await (await fetch(`examples/${file}`)).text();
    // Chosen twice, it may have come and been changed meanwhile.
    if (files.model(file) === undefined) files.open(file, text);
  }
  files.show(file);
}

/** @param {readonly File[]} chosen */
async function openFile([file]) {
  if (file === undefined) return;
  notice.hide();
  say("");
  const problem = sizeProblem(file.name, file.size);
  if (problem?.isRefused) {
    notice.tell(problem.sentence);
    return;
  }
  if (OF_OTHERS.test(file.name)) {
    await openConverted(file);
    return;
  }
  const name = file.name === CONFIGURATION ? CONFIGURATION : freeNameFor(properName(file.name));
  const former = name === CONFIGURATION && files.isChanged(name) ? files.kept()[name] : undefined;
  if (!openText(name, await file.text())) return;
  files.show(name);
  if (former) notice.tell(`${name} is the one that you opened now.`, [], { title: "Take the former", act: () => files.open(name, former.text, former.original) });
}

/**
 * The name, or one like it where a text of that name has been changed: what is opened replaces no work.
 * @param {string} name
 */
function freeNameFor(name) {
  return files.isChanged(name) ? files.freeName(name) : name;
}

/**
 * Open a text, unless it is too large; say so, and whether checking it takes long.
 * @param {string} name
 * @param {string} text
 */
function openText(name, text) {
  const problem = sizeProblem(name, text.length);
  if (problem) notice.tell(problem.sentence);
  if (!problem?.isRefused) files.open(name, text);
  return !problem?.isRefused;
}

/**
 * Open a robot of another format as a document, and tell what could not be kept.
 * @param {File} file
 */
async function openConverted(file) {
  try {
    const { text, remarks } = await port.command("kindsl.importRobot", file.name, await file.text());
    const name = files.freeName(properName(file.name.replace(/\.\w+$/, "")));
    if (!openText(name, text)) return;
    files.show(name);
    if (notice.place.hidden) notice.tell(`${file.name} is open as ${name}${remarks.length > 0 ? ":" : ""}`, remarks);
  } catch (error) {
    notice.tell(`${file.name}: ${messageOf(error)}`);
  }
}

const actions = {
  new() {
    const name = files.freeName("robot.kindsl");
    files.open(name, NEW_ROBOT);
    files.show(name);
  },
  open: () => byId("file").click(),
  format: () => editor.getAction("editor.action.formatDocument")?.run(),
  rename: () => {
    editor.focus();
    editor.trigger("bar", "editor.action.rename", {});
  },
  compare: () => {
    notice.hide();
    comparison.toggle();
  },
  download: () => download(files.active, files.model()?.getValue() ?? ""),
  urdf: downloadUrdf,
  share,
};
for (const [name, run] of Object.entries(actions)) byId(`do-${name}`).addEventListener("click", run);
for (const button of partButtons()) button.addEventListener("click", () => showPart(button.value));
/** @type {HTMLInputElement} */
const chosen = byId("file");
chosen.addEventListener("change", () => {
  void openFile([...(chosen.files ?? [])]);
  chosen.value = ""; // so that the same file can be opened again
});

/** @type {Readonly<Record<string, string>>} */
const examples = await (await fetch("examples/list.json")).json();
/** @type {HTMLSelectElement} */
const chooser = byId("examples");
for (const [name, title] of Object.entries(examples)) chooser.append(new Option(title, name));
chooser.addEventListener("change", () => {
  void addExample(chooser.value);
  chooser.selectedIndex = 0;
});

// To the client the port looks like the worker.
new MonacoLspClient(createTransportToWorker(/** @type {any} */ (port)));
const shared = await fromFragment(location.hash.slice(1));
if (restore()) {
  const asked = query.get("example");
  if (asked !== null && Object.hasOwn(examples, asked)) await addExample(asked);
} else if (shared !== undefined) {
  for (const [name, text] of Object.entries(shared.files)) openText(name === CONFIGURATION ? name : properName(name), text);
  if (files.names().length === 0) actions.new();
  files.show(files.names().includes(shared.active) ? shared.active : files.names()[0]);
} else {
  files.open(CONFIGURATION, await (await fetch(`examples/${CONFIGURATION}`)).text());
  const asked = query.get("example") ?? FIRST, isThere = Object.hasOwn(examples, asked);
  await addExample(isThere ? asked : FIRST);
  if (!isThere) notice.tell(`There is no example '${asked}'; here is '${FIRST}'. There are ${Object.keys(examples).join(", ")}`);
  if (location.hash.length > 1) notice.tell(`The address holds no texts that can be read; here is '${FIRST}'`);
}
if (shared !== undefined && narrow.matches) showPart("robot");
keptAs = keyOf(location);
if ("serviceWorker" in navigator && query.get("worker") !== "off") void navigator.serviceWorker.register("service_worker.js");
Object.assign(window, { playground: { monaco, editor, files, port, preview } });
