// Puts the page together: viewer, scene, panel, and the line to the server or the state of an exported page.
import { makeActions, showText, tell } from "./actions.js";
import { Address, eyeOf, eyeText } from "./address.js";
import { byId, partOf } from "./base/elements.js";
import { inUnit } from "./base/quantities.js";
import { Connection } from "./connection.js";
import { Editing } from "./editing/editing.js";
import { PullDrag } from "./editing/pull_drag.js";
import { History } from "./history.js";
import { Inbox } from "./inbox.js";
import { Compare } from "./panel/compare.js";
import { showCard, summary } from "./panel/card.js";
import { Findings, GREY } from "./panel/findings.js";
import { JointRows } from "./panel/joint_rows.js";
import { Keys } from "./panel/keys.js";
import { Legend } from "./panel/legend.js";
import { Player } from "./panel/player.js";
import { Poses, poseLines } from "./panel/poses.js";
import { MeshButton } from "./panel/mesh_button.js";
import { panelBars } from "./panel/splitter.js";
import { ParameterRows } from "./panel/parameter_rows.js";
import { showTitle } from "./panel/title.js";
import { Tree } from "./panel/tree.js";
import { Away } from "./picture/away.js";
import { Camera } from "./picture/camera.js";
import { Compass } from "./picture/compass.js";
import { boxesOn } from "./picture/label_places.js";
import { Labels } from "./picture/labels.js";
import { LineArt } from "./picture/line_art.js";
import { Measure } from "./picture/measure.js";
import { Motion } from "./picture/motion.js";
import { Picking } from "./picture/picking.js";
import { Presets } from "./picture/presets.js";
import { ScaleBar } from "./picture/scale_bar.js";
import { Scene } from "./picture/scene.js";
import { Stage } from "./picture/stage.js";
import { Selection } from "./base/selection.js";
import { Theme } from "./theme.js";
import { Units } from "./base/units.js";

/** @import { Request } from "./base/types.js" */
/** @import { Change, TrajectoryMessage } from "./messages.js" */
/** @import { Page } from "./page.js" */

/** @type {Readonly<Record<string, string>>} */
const STATES = {
  connecting: "connecting…", live: "live", reconnecting: "reconnecting…", exported: "exported", stale: "stale", incomplete: "incomplete",
};
const SOON = 1500; // ms in which what was kept is heard of
const pane = byId("pane"), embedded = document.getElementById("embedded-state");
const viewer = openViewer();
const theme = new Theme();
const scene = new Scene(viewer, theme.colors, loadMesh);
const page = /** @type {Page} */ ({
  viewer, scene, theme, pane, isStatic: Boolean(embedded), connection: null,
  send(request) { page.connection?.send(request); },
});
page.stage = new Stage(viewer, scene);
page.camera = new Camera(viewer, scene, pane);
page.selection = new Selection();
page.presets = new Presets(scene);
page.units = new Units();
page.inbox = new Inbox(scene);
page.measure = new Measure(scene, page.units, pane);
page.actions = makeActions(page);
page.lineArt = new LineArt(scene, pane);
page.labels = new Labels(scene, pane, page.actions, page.lineArt);
page.picking = new Picking(scene, pane, page.actions);
page.scaleBar = new ScaleBar(scene, page.camera, page.stage, pane);
page.away = new Away(scene, page.camera, pane, () => page.actions.frame());
page.compass = new Compass(scene, pane, page.camera);
page.joints = new JointRows(scene, page.units, page.actions);
page.parameters = new ParameterRows(page.units, page.actions);
page.poses = new Poses(scene, page.actions, (name, joints) => {
  if (page.isStatic) return showText("Lines to add to kindsl.toml", poseLines(name, joints));
  page.send({ type: "keep-pose", name, values: Object.fromEntries(joints) });
  setTimeout(() => {
    const isThere = [...page.inbox.poses.values()].some((pose) => pose.name === name) || document.querySelector("dialog[open]");
    if (!isThere) tell(`The pose '${name}' is offered here once kindsl.toml is saved.`);
  }, SOON);
});
page.tree = new Tree(scene, page.selection, page.actions);
page.findings = new Findings(pane, page.inbox, page.actions);
page.compare = new Compare({ ...page, choose: (name) => page.send({ type: "compare", name }), note: () => page.actions.note() });
page.meshes = new MeshButton(scene.meshes, () => page.send({ type: "show-meshes" }), () => page.actions.note());
page.legend = new Legend(scene, page.presets, page.actions);
page.bars = panelBars(() => page.address.note());
page.address = new Address(page);
page.pull = new PullDrag(page);
page.editing = new Editing(page);
page.labels.obstacles = () => [...page.editing.handles.boxes(), ...boxesOn(pane, [page.scaleBar.element, page.compass.svg])];
page.history = new History(takeState, putState, page.editing);
page.keys = new Keys(pane, page);
page.motion = new Motion(scene, {
  range: (joint) => page.joints.range(joint),
  onStop(names) {
    page.actions.tellPose(names.map((name) => [name, scene.q.get(name) ?? 0]));
    page.actions.note();
  },
});
page.player = new Player(scene, pane, (names) => {
  page.actions.tellPose(names.map((name) => [name, scene.q.get(name) ?? 0]));
  page.actions.note();
});
let connectionState = "connecting", isBegun = false;

/**
 * A mesh's file, from the page itself or its server, which wants the address' token.
 * @param {string} file
 */
async function loadMesh(file) {
  const embedded = page.inbox.meshData.get(file);
  if (embedded !== undefined) return Uint8Array.from(atob(embedded), (character) => character.charCodeAt(0)).buffer;
  if (page.isStatic) throw new Error("not in this page");
  const answer = await fetch(`mesh/${file}${location.search}`);
  if (!answer.ok) throw new Error(await answer.text());
  return answer.arrayBuffer();
}

function openViewer() {
  // An encoder in the viewer takes the window for its worker and posts back every message, its own again and again.
  window.onmessage = null;
  try {
    return new MeshCat.Viewer(pane);
  } catch (error) {
    byId("notice").hidden = false;
    partOf(byId("notice"), "button").textContent = "The preview needs WebGL, which this browser does not offer";
    throw error;
  }
}

// Pose and view, for undoing them.
function takeState() {
  return JSON.stringify([[...scene.q].filter(([, value]) => value !== 0).sort(), eyeText(page.camera.state())]);
}

/** @param {string} text */
function putState(text) {
  const [pose, view] = JSON.parse(text), eye = eyeOf(view);
  page.actions.setPose(new Map([...[...scene.q.keys()].map((name) => /** @type {const} */ ([name, 0])), ...pose]));
  if (eye && view !== eyeText(page.camera.state())) page.camera.restore(eye);
}

// The first whole robot: the view of the address, if there is one.
function begin() {
  isBegun = true;
  page.address.restore();
  scene.update();
  page.history.begin();
}

function follow() {
  page.presets.refresh();
  page.labels.forget();
  page.camera.follow();
  page.stage.drawGround();
}

function refresh() {
  if (page.inbox.isStale("compare")) {
    page.compare.show();
    page.legend.showGhost(page.inbox.ghost);
    page.meshes.show(page.inbox.meshes);
  }
  scene.update();
  const isDrawn = scene.trees.robot.links.size > 0;
  if (isDrawn && page.inbox.isStale("camera")) follow();
  if (isDrawn && !isBegun) begin();
  if (page.inbox.isStale("rows")) showRows();
  if (page.inbox.isStale("marks")) page.legend.showMore();
  if (page.inbox.isStale("values")) page.joints.update();
  if (page.inbox.isStale("torques")) page.player.renew();
  if (page.inbox.isStale("parameters")) page.parameters.update([...page.inbox.parameters.values()]);
  if (isDrawn && page.inbox.motion) startMotion(page.inbox.motion);
  if (page.inbox.isStale("poses")) page.poses.show([...page.inbox.poses.values()]);
  if (page.inbox.isStale("findings")) {
    page.findings.show();
    showHead();
  }
  if (page.selection.chosen) showCard(scene, page.selection.chosen, byId("selection"), page.inbox.status.is_former);
  page.lineArt.update();
  page.measure.update((position) => page.labels.project(position));
  page.stage.styleGround();
}

/** @param {TrajectoryMessage} motion */
function startMotion({ name, text }) {
  page.inbox.motion = null;
  page.player.load(name, text);
}

function showRows() {
  page.inbox.stale.add("poses");
  page.joints.update();
  page.tree.update();
  page.legend.show();
  const { name } = scene.model;
  byId("robot").textContent = name;
  byId("pane-title").textContent = name;
  byId("size").textContent = name ? inUnit(scene.bodies.size(), "m", 2) : "";
  showHead();
}

// Nothing is called live that stands greyed in the picture.
function showState() {
  const { state, is_former: isFormer } = page.inbox.status, isGrey = GREY.has(state);
  const shown = connectionState === "live" && isGrey ? (isFormer ? "stale" : "incomplete") : connectionState;
  document.body.dataset.state = shown;
  byId("state").textContent = STATES[shown];
}

function showHead() {
  showState();
  const { status: told } = page.inbox;
  byId("dof").textContent = scene.model.name ? summary(scene, told) : "";
  byId("dof").title = told.lacks || "";
  const { findings: { counts }, inbox: { status } } = page, words = page.findings.words();
  showTitle({ name: scene.model.name, words, counts, state: status.state, connection: connectionState });
}

// Before each picture everything is brought up to date, after it the names are put in place.
const render = viewer.render.bind(viewer);
viewer.render = () => {
  refresh();
  render();
  page.editing.place();
  page.labels.place();
  page.compass.update();
  page.scaleBar.update();
  page.away.update();
  page.compare.place();
};

// Only meshcat's drawing commands and our own messages; anything else, such as `set_control`, is ignored.
/** @type {(message: unknown) => void} */
const onMessage = (message) => page.inbox.take(/** @type {Change} */ (message));
viewer.handle_command = onMessage;

// The canvas fills its pane, not the window.
viewer.set_3d_pane_size = () => {
  viewer.camera.aspect = pane.clientWidth / Math.max(1, pane.clientHeight);
  viewer.camera.updateProjectionMatrix();
  viewer.renderer.setSize(pane.clientWidth, pane.clientHeight);
  page.camera.resized();
  viewer.set_dirty();
};

// What the server says goes on to those whom it concerns.
/** @param {Page} page */
function passOn({ inbox, editing, selection }) {
  inbox.onEditing = (message) => editing.take(message);
  inbox.onForget = (path) => editing.forget(path);
  inbox.onCursor = (thing) => selection.follow(thing);
  inbox.onLines = (text) => showText("Lines to add to kindsl.toml", text);
}

/** @param {string} state */
function onState(state) {
  connectionState = state;
  showState();
  if (scene.model.name) showHead();
  if (state === "live") page.editing.rejoin();
}

const nameTheme = () => {
  const now = theme.choice === "auto" ? "those of the system or editor" : theme.choice;
  Object.assign(byId("theme"), { textContent: `Use ${theme.next}`, title: `Colours are ${now}` });
};
nameTheme();
theme.onChange = () => {
  scene.setColors(theme.colors);
  page.legend.show();
  nameTheme();
};
passOn(page);
page.camera.onMove(page.actions.note);
page.selection.onChange(() => {
  scene.highlight(page.selection.lit);
  showCard(scene, page.selection.chosen, byId("selection"), page.inbox.status.is_former);
  byId("inspector").scrollTop = 0;
});

const hash = new URLSearchParams(location.hash.slice(1));
document.body.classList.toggle("picture", hash.has("picture"));
page.address.restorePage();
const onFrame = (/** @type {Uint8Array} */ frame) => viewer.handle_command_bytearray(frame);
/** @returns {Request} */
const greeting = () => ({ type: "hello", joints: Object.fromEntries(scene.q), parameters: page.inbox.typedValues() });
if (embedded) {
  onState("exported");
  onFrame(Uint8Array.from(atob((embedded.textContent ?? "").trim()), (character) => character.charCodeAt(0)));
  // Drawn before the page counts as loaded: who takes a picture of it then has it whole.
  viewer.set_3d_pane_size();
  viewer.render();
} else page.connection = new Connection({ onFrame, onMessage, onState, greeting });
new ResizeObserver(() => viewer.set_3d_pane_size()).observe(pane);

// For whoever looks into the page: its console, an editor's panel that gives its colours, a test.
Object.assign(globalThis, { kindsl: page });
