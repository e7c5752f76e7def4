// The numbers of the selected link, joint or frame.
import { format, make, partOf } from "../base/elements.js";
import { IDENTITY, intrinsicXyz, originOf, zAxisOf } from "../picture/kinematics.js";

/** @import { Matrix, Poses, Thing, Tree } from "../base/types.js" */
/** @import { JointMessage, LinkMessage, StatusMessage } from "../messages.js" */
/** @import { Scene } from "../picture/scene.js" */
/** @typedef {readonly [title: string, text: string]} Row */

/** @param {readonly number[]} values @param {number} [digits] */
const vector = (values, digits) => `(${values.map((value) => format(value, digits)).join(", ")})`;
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
  if (kind === "link") return link && linkRows(link, robot, poses.robot, model.is_floating);
  if (kind === "joint") return joint && jointRows(scene, joint);
  return frame && [["Fixed to", frame.link]];
}

/** @param {LinkMessage} link @param {Tree} tree @param {Poses} poses @param {boolean} isFloating @returns {Row[]} */
function linkRows(link, tree, poses, isFloating) {
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
  if (!link.is_consistent) list.push(["", "no rigid body has this inertia"]);
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
  const count = scene.trees.robot.joints.size, known = `${format(mass, 3)} kg`;
  const told = !lacks ? known : mass > 0 ? `at least ${known}` : "mass unknown";
  return `${count} joint${count === 1 ? "" : "s"}, ${told}${isFormer ? " (stale)" : ""}`;
}

/** @param {Scene} scene @param {Thing | null} chosen @param {HTMLElement} section */
export function showCard(scene, chosen, section) {
  const list = chosen && rows(scene, chosen);
  section.hidden = !list;
  if (!list) return;
  partOf(section, "h3").textContent = `${chosen.kind} ${chosen.name}`;
  const table = partOf(section, "dl");
  table.replaceChildren();
  for (const [title, text] of list) table.append(make("dt", "", title), make("dd", title ? "" : "note", text));
}
