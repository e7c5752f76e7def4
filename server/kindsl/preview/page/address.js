// What the page shows, in its address' fragment: #preset=Frames&q=LF_HFE:0.7&eye=... A reload, a second tab or a link
// to it shows the same. It is written at rest, never while something moves, and it never reaches the server.
import { FIRST_PRESET } from "./picture/presets.js";

const REST = 300; // milliseconds
const MOST_VALUES = 200; // joints away from zero
const DIGITS = 5;

export class Address {
  constructor(parts) {
    Object.assign(this, parts); // scene, camera, presets, selection, theme, units, actions
    this.isRestored = false;
    addEventListener("hashchange", () => this.restore());
  }

  // Called when something has changed that the address tells.
  note() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.write(), REST);
  }

  write() {
    if (this.isRestored) history.replaceState(null, "", this.text());
  }

  link() { return location.href.split("#")[0] + this.text(); }

  text() {
    const { camera, presets, scene, selection, theme, units } = this, parts = new URLSearchParams(location.hash.slice(1));
    const put = (name, value) => (value ? parts.set(name, value) : parts.delete(name));
    put("preset", presets.name === FIRST_PRESET ? "" : presets.name);
    put("show", [...presets.own].map(([key, { visible, opacity }]) => `${key}:${visible ? opacity : 0}`).join(","));
    put("pick", selection.chosen && `${selection.chosen.kind}:${selection.chosen.name}`);
    put("q", poseText(scene.q));
    put("eye", camera.isUsers ? eyeText(camera.state()) : "");
    put("hide", [...scene.hidden.links].map(encodeURIComponent).join(","));
    put("only", scene.hidden.isolated);
    put("theme", theme.choice === "auto" ? "" : theme.choice);
    put("angle", units.angle === "rad" ? "" : units.angle);
    return `#${parts}`;
  }

  // Take what the address tells; whatever it does not say or the robot has not stays as it is.
  restore() {
    const told = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
    const { scene, presets, camera, actions } = this, { links, joints } = scene.trees.robot;
    this.isRestored = true;
    if (told.theme) this.actions.chooseTheme(told.theme);
    if (told.angle) this.units.choose(told.angle);
    if (told.preset) presets.choose(told.preset);
    for (const [key, opacity] of pairs(told.show)) presets.set(key, opacity > 0, opacity || presets.usual(key).opacity);
    actions.setPose(new Map(pairs(told.q).filter(([name]) => joints.has(name))));
    for (const link of words(told.hide)) if (links.has(link) && !scene.hidden.links.has(link)) scene.hidden.toggle(link);
    if (links.has(told.only) && scene.hidden.isolated !== told.only) scene.hidden.isolate(told.only);
    const eye = eyeOf(told.eye), [, kind, name] = /^(link|joint|frame):(.*)$/s.exec(told.pick || "") || [];
    if (eye) camera.restore(eye);
    if (kind && scene.trees.robot[`${kind}s`].has(name)) this.selection.choose({ kind, name });
    scene.changed("view");
  }
}

const number = (value) => Number(value.toPrecision(DIGITS));
const words = (text) => (text || "").split(",").filter(Boolean).map(decoded).filter((word) => word !== null);

// Text as it was before it was put in an address; null if it never was.
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return null;
  }
}

function poseText(q) {
  const moved = [...q].filter(([, value]) => value !== 0).slice(0, MOST_VALUES);
  return moved.map(([name, value]) => `${encodeURIComponent(name)}:${number(value)}`).join(",");
}

// [[name, value], ...]
function pairs(text) {
  return (text || "").split(",").map((pair) => pair.split(":"))
    .map(([name, value]) => [decoded(name), value === undefined || value === "" ? NaN : Number(value)])
    .filter(([name, value]) => name && Number.isFinite(value));
}

export const eyeText = ({ position, target }) => [...position, ...target].map(number).join(",");

export function eyeOf(text) {
  const numbers = (text || "").split(",").map(Number);
  const isEye = numbers.length === 6 && numbers.every(Number.isFinite) && numbers.some((value, i) => i < 3 && value !== numbers[i + 3]);
  return isEye ? { position: numbers.slice(0, 3), target: numbers.slice(3) } : null;
}
