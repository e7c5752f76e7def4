// Places that depend on parameters, evaluated in an exported page, where no server reads the document.
import { poseMatrix } from "./picture/kinematics.js";

/** @import { Vector } from "./base/types.js" */
/** @import { FormulaMessage } from "./messages.js" */
/** @import { Scene } from "./picture/scene.js" */
/** @typedef {FormulaMessage["rotation"][number]} Formula */
/** @typedef {ReadonlyMap<string, number>} Values */

/**
 * [constant, [[parameter, factor], ...]]; a parameter without a value counts as zero.
 * @param {Formula} formula
 * @param {Values} values
 */
function evaluate([constant, terms], values) {
  return terms.reduce((sum, [name, factor]) => sum + factor * (values.get(name) || 0), constant);
}

/** @type {(formulas: readonly Formula[], values: Values) => Vector} */
const evaluated = ([x, y, z], values) => [evaluate(x, values), evaluate(y, values), evaluate(z, values)];

/**
 * Place again what the formulas speak of. `values` has the parameters by name.
 * @param {Scene} scene
 * @param {readonly FormulaMessage[]} formulas
 * @param {Values} values
 */
export function applyFormulas(scene, formulas, values) {
  for (const formula of formulas) {
    const translation = evaluated(formula.translation, values);
    const isPlaced = scene.placeThing(formula, poseMatrix(translation, evaluated(formula.rotation, values)));
    if (!isPlaced) continue;
    moveBody(scene, formula, translation);
  }
  scene.changed("joint");
}

/**
 * The capsule from the carrying link's frame to the joint or frame.
 * @param {Scene} scene
 * @param {FormulaMessage} formula
 * @param {Vector} translation
 */
function moveBody(scene, { rod, end }, translation) {
  if (!scene.marks.byPath.has(rod)) return;
  scene.apply({ type: "set_transform", path: rod, matrix: along(translation) });
  scene.apply({ type: "set_transform", path: end, matrix: poseMatrix(translation, [0, 0, 0]) });
}

/**
 * Stretch a unit cylinder, along y, from the origin to `end`.
 * @param {Vector} end
 */
function along(end) {
  const direction = new MeshCat.THREE.Vector3(...end), length = Math.max(direction.length(), 1e-9);
  const turn = new MeshCat.THREE.Quaternion();
  turn.setFromUnitVectors(new MeshCat.THREE.Vector3(0, 1, 0), direction.clone().normalize());
  const middle = direction.clone().multiplyScalar(0.5), scale = new MeshCat.THREE.Vector3(1, length, 1);
  return new MeshCat.THREE.Matrix4().compose(middle, turn, scale).toArray();
}
