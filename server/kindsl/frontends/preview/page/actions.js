// What the user can do, whatever it is done with: mouse, touch, keyboard, panel or picture.
import { byId, make } from "./base/elements.js";
import { drawPicture, savePicture } from "./picture/snapshot.js";

/** @import { Actions, NamedValue } from "./base/types.js" */
/** @import { Page } from "./page.js" */

const MOST_AT_ONCE = 500; // values in a message to the server
/** @param {readonly NamedValue[]} parameters */
const byName = (parameters) => Object.fromEntries(parameters.map(({ name, value }) => [name, value]));

/**
 * More parts may be added to `page` later.
 * @param {Page} page
 * @returns {Actions}
 */
export function makeActions(page) {
  const { scene, selection, camera, presets } = page;
  const note = () => { page.history.note(); page.address.note(); };
  /** @type {Actions} */
  const actions = {
    isStatic: page.isStatic,
    note,
    setJoint(name, value) {
      scene.q.set(name, value);
      scene.changed("value");
      page.send({ type: "set-joints", values: { [name]: value } });
      note();
    },
    // Several joints at once, by name.
    setPose(values) {
      const changed = [...values].filter(([name, value]) => (scene.q.get(name) || 0) !== value);
      for (const [name, value] of changed) scene.q.set(name, value);
      if (!changed.length) return;
      scene.changed("value");
      actions.tellPose(changed);
      note();
    },
    tellPose(values) {
      for (let at = 0; at < values.length; at += MOST_AT_ONCE) {
        page.send({ type: "set-joints", values: Object.fromEntries(values.slice(at, at + MOST_AT_ONCE)) });
      }
    },
    zero: () => page.joints.zero(),
    setParameter(name, value) {
      if (page.isStatic) page.inbox.setParameter(name, value);
      else page.send({ type: "set-parameters", values: { [name]: value } });
    },
    setParameters(parameters) {
      if (page.isStatic) for (const { name, value } of parameters) page.inbox.setParameter(name, value);
      else page.send({ type: "set-parameters", values: byName(parameters) });
    },
    writeParameters: (parameters) => page.send({ type: "write-parameters", values: byName(parameters) }),
    setView(key, visible, opacity) {
      presets.set(key, visible, opacity);
      note();
    },
    choosePreset(name) {
      presets.choose(name);
      note();
    },
    resetPreset() {
      presets.reset();
      note();
    },
    showOversized(isShown) {
      scene.showsOversized = isShown;
      scene.changed("view");
      page.legend.show();
    },
    chooseTheme(choice) {
      page.theme.choose(choice);
      note();
    },
    hover: (thing) => selection.hover(thing),
    reveal(thing) {
      if (page.measure.take(thing)) return;
      selection.choose(thing);
      page.send({ type: "reveal", kind: thing.kind, name: thing.name });
      note();
    },
    clear() {
      if (page.measure.isOn) page.measure.toggle();
      selection.choose(null);
      note();
    },
    frame() {
      camera.frame();
      note();
    },
    focus() {
      const thing = selection.chosen;
      if (thing) camera.focus(camera.pointsOf(thing));
      else actions.frame();
    },
    animate: (name) => page.motion.toggle(name),
    measure: () => page.measure.toggle(),
    savePicture: () => savePicture(drawPicture(page.viewer, page.labels, page.pane), scene.model.name),
    copyLink: () => copy(page.address.link(), page.isStatic),
    showKeys: () => page.keys.show(),
    foldPanel(isFolded = !document.body.classList.contains("folded")) {
      document.body.classList.toggle("folded", isFolded);
      byId("open-panel").hidden = !isFolded;
    },
  };
  connect(actions, page);
  return actions;
}

/** @param {Actions} actions @param {Page} page */
function connect(actions, page) {
  /** @type {(id: string, act: () => void) => void} */
  const on = (id, act) => byId(id).addEventListener("click", act);
  on("zero", () => actions.zero());
  on("frame", () => actions.frame());
  on("animate", () => actions.animate(null));
  on("measure", () => actions.measure());
  on("png", () => actions.savePicture());
  on("link", () => actions.copyLink());
  on("help", () => actions.showKeys());
  on("theme", () => actions.chooseTheme(page.theme.next));
  on("close-panel", () => actions.foldPanel(true));
  on("open-panel", () => actions.foldPanel(false));
  // The viewer's controls would take the press for the start of a turn.
  byId("open-panel").addEventListener("pointerdown", (event) => event.stopPropagation());
  on("angle-unit", () => {
    page.units.choose(page.units.angle === "rad" ? "deg" : "rad");
    actions.note();
  });
  page.units.onChange(() => {
    const [other, now] = page.units.angle === "rad" ? ["degrees", "radians"] : ["radians", "degrees"];
    Object.assign(byId("angle-unit"), { textContent: `Use ${other}`, title: `Angles are shown in ${now}` });
  });
}

/**
 * Put a link on the clipboard and say for how long it leads here; where the clipboard is forbidden, show it.
 * @param {string} link
 * @param {boolean} isLasting
 */
async function copy(link, isLasting) {
  const limit = isLasting ? "" : "It opens on this computer only, while this preview runs: 'kindsl preview FILE --export PAGE.html' writes a page to send.";
  try {
    await navigator.clipboard.writeText(link);
    tell(`Copied the link to this view. ${limit}`);
  } catch {
    showText("Link to this view", link, limit);
  }
}

/**
 * Say something for a while, over all else.
 * @param {string} text
 */
export function tell(text) {
  const box = byId("told");
  box.textContent = text;
  box.showPopover();
  setTimeout(() => box.textContent === text && box.hidePopover(), 8000);
}

/**
 * A text to be selected and copied by hand, and what to know of it.
 * @param {string} title
 * @param {string} text
 * @param {string} [note]
 */
export function showText(title, text, note) {
  const dialog = make("dialog"), form = make("form");
  dialog.ariaLabel = title;
  dialog.append(make("h2", "", title), make("pre", "", text), ...(note ? [make("p", "", note)] : []), form);
  form.method = "dialog";
  form.append(make("button", "", "Close"));
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
}
