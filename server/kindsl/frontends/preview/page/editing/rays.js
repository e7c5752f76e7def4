// From the mouse to the robot: rays in the base's coordinates, and where they meet lines and planes.

/** @import { Viewer } from "../base/types.js" */
/** @typedef {{ readonly origin: THREE.Vector3, readonly direction: THREE.Vector3 }} Ray in the base's coordinates */
/** @typedef {{ readonly clientX: number, readonly clientY: number }} Mouse */

const { Matrix4, Raycaster, Vector2, Vector3 } = MeshCat.THREE;

/**
 * Through what is under the mouse.
 * @param {Viewer} viewer
 * @param {Mouse} event
 * @returns {Ray}
 */
export function rayOf(viewer, event) {
  const box = viewer.renderer.domElement.getBoundingClientRect(), caster = new Raycaster();
  const x = (2 * (event.clientX - box.left)) / box.width - 1, y = 1 - (2 * (event.clientY - box.top)) / box.height;
  caster.setFromCamera(new Vector2(x, y), viewer.camera);
  const toBase = new Matrix4().copy(viewer.scene.matrixWorld).invert();
  const origin = caster.ray.origin.clone().applyMatrix4(toBase);
  return { origin, direction: caster.ray.direction.clone().transformDirection(toBase) };
}

/**
 * How far along a line the point is that comes closest to a ray; null where they are parallel.
 * @param {Ray} ray
 * @param {THREE.Vector3} point
 * @param {THREE.Vector3} axis
 */
export function alongLine({ origin, direction }, point, axis) {
  const across = direction.dot(axis), offset = new Vector3().subVectors(point, origin);
  const bottom = 1 - across * across;
  return bottom < 1e-6 ? null : (across * offset.dot(direction) - offset.dot(axis)) / bottom;
}

/**
 * Where a ray meets a plane; null where it does not.
 * @param {Ray} ray
 * @param {THREE.Vector3} point
 * @param {THREE.Vector3} normal
 */
export function onPlane({ origin, direction }, point, normal) {
  const slope = direction.dot(normal);
  if (Math.abs(slope) < 1e-6) return null;
  const distance = new Vector3().subVectors(point, origin).dot(normal) / slope;
  return distance < 0 ? null : origin.clone().addScaledVector(direction, distance);
}

/** @param {number} angle */
export const wrappedAngle = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));

/**
 * The angle from one arm to another about an axis, both seen from a pivot.
 * @param {THREE.Vector3} axis
 * @param {THREE.Vector3} pivot
 * @param {THREE.Vector3} from
 * @param {THREE.Vector3} to
 */
export function angleBetween(axis, pivot, from, to) {
  const a = from.clone().sub(pivot).projectOnPlane(axis), b = to.clone().sub(pivot).projectOnPlane(axis);
  return Math.atan2(a.clone().cross(b).dot(axis), a.dot(b));
}
