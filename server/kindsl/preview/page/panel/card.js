// The numbers of the selected link, joint or frame.
import { format, make } from "../base/elements.js";
import { intrinsicXyz, originOf, zAxisOf } from "../picture/kinematics.js";

const vector = (values, digits) => `(${values.map((value) => format(value, digits)).join(", ")})`;
const moment = (value) => (value === 0 ? "0" : Number(value.toPrecision(4)).toString());

const position = (pose) => `${vector(originOf(pose))} m`;
const rotation = (pose) => `${vector(intrinsicXyz(pose))} rad`;
const axis = (pose) => vector(zAxisOf(pose));

// Rows of [title, text] for the chosen thing; null if it is not there.
function rows(scene, { kind, name }) {
  const poses = scene.poses.robot, tree = scene.trees.robot, group = kind + "s";
  const entity = tree[group] && tree[group].get(name);
  const pose = poses && poses[group] && poses[group].get(name);
  if (!entity || !pose) return null;
  const more = { link: () => linkRows(entity, tree, poses, scene.model.is_floating), joint: () => jointRows(scene, entity, pose) }[kind];
  const list = [["Position", position(pose)], ["Rotation", rotation(pose)]];
  return list.concat(more ? more() : [["Fixed to", entity.link]]);
}

function linkRows(link, tree, poses, isFloating) {
  const list = [];
  const joint = tree.joints.get(link.joint);
  if (joint) list.push(["Moved by", `${joint.name} (${joint.kind})`], ["Axis", axis(poses.joints.get(joint.name))]);
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

function jointRows(scene, joint, pose) {
  const [unit, force] = joint.kind === "prismatic" ? ["m", "N"] : ["rad", "N m"];
  const told = scene.limits.get(joint.name), limits = told ? [told.minimum, told.maximum] : [];
  return [
    ["Kind", joint.kind], ["Axis", axis(pose)],
    ["Moves", `${joint.predecessor} → ${joint.successor}`],
    ["Value", `${format(scene.q.get(joint.name) || 0)} ${unit}`],
    ...(told ? [["Limits", `${limits.map((limit) => (limit === null ? "none" : format(limit))).join(" to ")} ${unit}`]] : []),
    ...(joint.is_guess ? [["", "a parameter without a value: its place is a guess"]] : []),
    ["Gravity", scene.torques.has(joint.name) ? `${format(scene.torques.get(joint.name), 3)} ${force}` : "unknown"],
  ];
}

// One line about the whole robot; a part of its mass never reads like the whole.
export function summary(scene, { mass = 0, lacks, is_former: isFormer }) {
  const count = scene.trees.robot.joints.size, known = `${format(mass, 3)} kg`;
  const told = !lacks ? known : mass > 0 ? `at least ${known}` : "mass unknown";
  return `${count} joint${count === 1 ? "" : "s"}, ${told}${isFormer ? " (stale)" : ""}`;
}

export function showCard(scene, chosen, section) {
  const list = chosen && rows(scene, chosen);
  section.hidden = !list;
  if (!list) return;
  section.querySelector("h3").textContent = `${chosen.kind} ${chosen.name}`;
  const table = section.querySelector("dl");
  table.replaceChildren();
  for (const [title, text] of list) table.append(make("dt", "", title), make("dd", title ? "" : "note", text));
}
