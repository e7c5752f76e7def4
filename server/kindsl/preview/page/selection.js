// The numbers of the selected link, joint or frame.
"use strict";

const KindslSelection = (() => {
  const { format, make } = KindslPanel;
  const vector = (values, digits) => `(${values.map((value) => format(value, digits)).join(", ")})`;
  const moment = (value) => (value === 0 ? "0" : Number(value.toPrecision(4)).toString());

  // Rows of [title, text] for the chosen thing.
  function rows(scene, { kind, name }) {
    const poses = scene.poses.robot, tree = scene.trees.robot;
    const entity = tree[kind + "s"] && tree[kind + "s"].get(name);
    const pose = poses && poses[kind + "s"] && poses[kind + "s"].get(name);
    if (!entity || !pose) return null;
    const list = [["Position", `${vector(KindslKinematics.origin(pose))} m`], ["Rotation", `${vector(KindslKinematics.intrinsicXyz(pose))} rad`]];
    if (kind === "link") list.push(...linkRows(entity, tree, poses));
    if (kind === "joint") list.push(...jointRows(scene, entity, pose));
    if (kind === "frame") list.push(["Fixed to", entity.link]);
    return list;
  }

  function linkRows(link, tree, poses) {
    const list = [];
    const joint = tree.joints.get(link.joint);
    if (joint) list.push(["Moved by", `${joint.name} (${joint.kind})`], ["Axis", vector(KindslKinematics.zAxis(poses.joints.get(joint.name)))]);
    list.push(["Mass", `${format(link.mass, 5)} kg`], ["Centre of mass", `${vector(link.com)} m`]);
    const [xx, , , xy, yy, , xz, yz, zz] = link.inertia;
    list.push(["Inertia", `${[xx, yy, zz].map(moment).join("  ")}`], ["Products", `${[-xy, -xz, -yz].map((v) => moment(v + 0)).join("  ")}`]);
    list.push(["", "about the centre of mass, link axes, kg m²"]);
    if (!link.is_consistent) list.push(["", "no rigid body has this inertia"]);
    return list;
  }

  function jointRows(scene, joint, pose) {
    const unit = joint.kind === "prismatic" ? ["m", "N"] : ["rad", "N m"];
    return [
      ["Kind", joint.kind], ["Axis", vector(KindslKinematics.zAxis(pose))],
      ["Moves", `${joint.predecessor} → ${joint.successor}`], ["Value", `${format(scene.q.get(joint.name) || 0)} ${unit[0]}`],
      ["Gravity", `${format(scene.torques.get(joint.name) || 0, 3)} ${unit[1]}`],
    ];
  }

  function show(scene, chosen, section) {
    const list = chosen && rows(scene, chosen);
    section.hidden = !list;
    if (!list) return;
    section.querySelector("h2").textContent = `${chosen.kind} ${chosen.name}`;
    const table = section.querySelector("dl");
    table.replaceChildren();
    for (const [title, text] of list) table.append(make("dt", "", title), make("dd", title ? "" : "note", text));
  }

  return { show };
})();
