// The numbers of the selected link, joint or frame.
import { format, make, partOf } from "../base/elements.js";
import { inUnit } from "../base/quantities.js";
import { shapeOf } from "../picture/pieces.js";
import { IDENTITY, intrinsicXyz, originOf, zAxisOf } from "../picture/kinematics.js";

/** @import { Matrix, Poses, Thing, Tree } from "../base/types.js" */
/** @import { Core, JointMessage, LinkMessage, ModelMessage, SolidMessage, StatusMessage } from "../messages.js" */
/** @import { Scene } from "../picture/scene.js" */
/** @typedef {readonly [title: string, text: string, look?: string]} Row */

const HOLLOW = 0.97; // a shell is smaller than the solid by more than this

/** @param {readonly number[]} values @param {number} [digits] */
const vector = (values, digits) => `(${values.map((value) => format(value, digits)).join(", ")})`;
/** @param {number} value */
const digits = (value, count = 4) => String(Number(value.toPrecision(count)));
/** @param {number} value */
const moment = (value) => (value === 0 ? "0" : Number(value.toPrecision(4)).toString());

/** @param {Matrix} pose */
const position = (pose) => `${vector(originOf(pose))} m`;
/** @param {Matrix} pose */
const rotation = (pose) => `${vector(intrinsicXyz(pose))} rad`;
/** @param {Matrix} pose */
const axis = (pose) => vector(zAxisOf(pose));

/**
 * Rows for the chosen thing; null if it is not there.
 * @param {Scene} scene
 * @param {Thing} thing
 * @returns {Row[] | null}
 */
function rows(scene, { kind, name }) {
  const pose = scene.poseOf({ kind, name }), more = moreRows(scene, { kind, name });
  return pose && more ? [["Position", position(pose)], ["Rotation", rotation(pose)], ...more] : null;
}

/** @param {Scene} scene @param {Thing} thing @returns {Row[] | undefined} */
function moreRows(scene, { kind, name }) {
  const { trees: { robot }, poses, model } = scene;
  const [link, joint, frame] = [robot.links.get(name), robot.joints.get(name), robot.frames.get(name)];
  if (kind === "link") return link && linkRows(link, robot, poses.robot, model);
  if (kind === "joint") return joint && jointRows(scene, joint);
  return frame && [["Fixed to", frame.link]];
}

/** @param {SolidMessage | undefined} solid @param {number} usual Density of the robot's links, kg/m³. @returns {Row[]} */
function bodyRows(solid, usual) {
  const core = solid?.core, doubts = solid?.doubts ?? [];
  /** @type {Row[]} */
  const list = core ? [["As a body", `${shapeOf(core)} ${sizes(core, 1)}, ${digits(core.density, 2)} kg/m³`]] : [];
  if (core && core.shell < HOLLOW) list.push(["", `as a shell of the usual ${digits(usual, 2)} kg/m³ ${sizes(core, core.shell)}`]);
  return [...list, ...doubts.map(({ code, sentence }) => /** @type {Row} */ (["", `${sentence} (${code})`, "doubt"]))];
}

/** @param {Core} core @param {number} factor */
const sizes = ({ semi_axes: halves }, factor) => (
  `${halves.map((half) => digits(2 * half * factor, 2)).sort((a, b) => Number(b) - Number(a)).join(" × ")} m`);

/** @param {LinkMessage} link @param {Tree} tree @param {Poses} poses @param {Pick<ModelMessage, "is_floating" | "density">} model @returns {Row[]} */
function linkRows(link, tree, poses, { is_floating: isFloating, density }) {
  /** @type {Row[]} */
  const list = [];
  const joint = tree.joints.get(link.joint), pose = poses.joints.get(link.joint);
  if (joint && pose) list.push(["Moved by", `${joint.name} (${joint.kind})`], ["Axis", axis(pose)]);
  if (link.lacks) return [...list, ["Inertia", "unknown"], ["", link.lacks]];
  list.push(["Mass", `${format(link.mass, 5)} kg`], ["Centre of mass", `${vector(link.com)} m`]);
  // The tensor's other entries are the products of inertia with their signs changed.
  const [xx, , , xy, yy, , xz, yz, zz] = link.inertia;
  list.push(["Inertia", [xx, yy, zz].map(moment).join("  ")]);
  list.push(["Products", [xy, xz, yz].map((entry) => moment(0 - entry)).join("  ")]);
  list.push(["", "about the centre of mass, link axes, kg m²"]);
  list.push(...bodyRows(tree.solids.get(link.name), density));
  if (!joint && !isFloating) list.push(["", "a fixed base: its mass counts nowhere"]);
  return list;
}

/** @param {Scene} scene @param {JointMessage} joint @returns {Row[]} */
function jointRows(scene, joint) {
  const [unit, force] = joint.kind === "prismatic" ? ["m", "N"] : ["rad", "N m"];
  const told = scene.limits.get(joint.name), limits = told ? [told.minimum, told.maximum] : [];
  const torque = scene.torques.get(joint.name), pose = scene.poses.robot.joints.get(joint.name) ?? IDENTITY;
  return [
    ["Kind", joint.kind], ["Axis", axis(pose)],
    ["Moves", `${joint.predecessor} → ${joint.successor}`],
    ["Value", `${format(scene.q.get(joint.name) || 0)} ${unit}`],
    ...rowsIf(told, "Limits", `${limits.map((limit) => (limit === null ? "none" : format(limit))).join(" to ")} ${unit}`),
    ...rowsIf(joint.is_guess, "", "a parameter without a value: its place is a guess"),
    ["Gravity", torque === undefined ? "unknown" : `${format(torque, 3)} ${force}`],
  ];
}

/** @type {(is: unknown, title: string, text: string) => Row[]} */
const rowsIf = (is, title, text) => (is ? [[title, text]] : []);

/**
 * One line about the whole robot; a part of its mass never reads like the whole.
 * @param {Scene} scene
 * @param {Pick<StatusMessage, "mass" | "lacks" | "is_former">} status
 */
export function summary(scene, { mass, lacks, is_former: isFormer }) {
  const count = scene.trees.robot.joints.size, known = inUnit([mass], "kg");
  const told = !lacks ? known : mass > 0 ? `at least ${known}` : "mass unknown";
  return `${count} joint${count === 1 ? "" : "s"}, ${told}${isFormer ? " (stale)" : ""}`;
}

/** @param {Scene} scene @param {Thing | null} chosen @param {HTMLElement} section @param {boolean} isFormer Whether the document has changed since. */
export function showCard(scene, chosen, section, isFormer) {
  const list = chosen && rows(scene, chosen);
  section.hidden = !list;
  if (!list) return;
  partOf(section, "h3").textContent = `${chosen.kind} ${chosen.name}${isFormer ? " (stale)" : ""}`;
  const table = partOf(section, "dl");
  table.replaceChildren();
  for (const [title, text, look] of list) table.append(make("dt", "", title), make("dd", look ?? (title ? "" : "note"), text));
}
