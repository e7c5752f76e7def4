// A press on a handle, until it is let go: which value the mouse means. Shift snaps finely, Ctrl not at all.
import { alongLine, angleBetween, onPlane, rayOf, wrappedAngle } from "./rays.js";

/** @import { Viewer } from "../base/types.js" */
/** @import { Handles } from "./handles.js" */
/** @typedef {{ readonly shiftKey: boolean, readonly ctrlKey?: boolean, readonly metaKey?: boolean }} Modifiers */
/** @typedef {number | THREE.Vector3} Where a distance along an arrow, a place in a ring's plane, or the angle that its near side rolls by */

/**
 * @typedef {object} Held
 * @property {string} component
 * @property {number} value Where the drag began, metres or radians.
 * @property {THREE.Vector3} axis
 * @property {THREE.Vector3} origin
 * @property {number} reach A ring's radius, metres.
 * @property {boolean} isRing
 * @property {boolean} isEdgeOn
 * @property {number} last Radians turned up to now.
 * @property {number} pointer
 * @property {Where} from
 */

const { Vector3 } = MeshCat.THREE;
const DEGREE = Math.PI / 180;
const STEPS = { length: [0.01, 0.001], angle: [15 * DEGREE, 5 * DEGREE] };
const FREE = { length: 1e4, angle: 1e3 }; // parts of a metre, of a radian, that a free value is told in
const GRAZING = 0.2; // below this a ring is seen from its edge

/** @param {string} component @returns {"angle" | "length"} */
export const unitOf = (component) => (component.length === 2 ? "angle" : "length");

/**
 * What numbers snap to, and what finely.
 * @param {string} component
 */
export const stepsOf = (component) => STEPS[unitOf(component)];

/**
 * What a value is to be a multiple of; null for any value.
 * @param {string} component
 * @param {Modifiers} event
 */
const stepOf = (component, { shiftKey, ctrlKey, metaKey }) =>
  ctrlKey || metaKey ? null : stepsOf(component)[shiftKey ? 1 : 0];

/** @param {string} component @param {number} value @param {number | null} step */
export function snapped(component, value, step) {
  const parts = FREE[unitOf(component)];
  return step === null ? Math.round(value * parts) / parts : step * Math.round(value / step);
}

export class HandleDrag {
  /** @type {Held | null} */
  held = null;

  /** @param {Viewer} viewer @param {Pick<Handles, "geometry" | "radius">} handles */
  constructor(viewer, handles) {
    this.viewer = viewer;
    this.handles = handles;
  }

  get isOn() { return this.held !== null; }

  /**
   * Whether an event is of the finger or mouse that holds the handle.
   * @param {PointerEvent} event
   */
  holds({ pointerId }) { return this.held !== null && this.held.pointer === pointerId; }

  /**
   * Whether a handle could be taken; `value` is its number now.
   * @param {string} component
   * @param {number} value
   * @param {PointerEvent} event
   */
  begin(component, value, event) {
    const geometry = this.handles.geometry();
    if (!geometry) return false;
    const axis = geometry.axes[component].clone(), origin = geometry.origin.clone();
    const ray = rayOf(this.viewer, event), isRing = component.length === 2;
    const isEdgeOn = isRing && Math.abs(ray.direction.dot(axis)) < GRAZING;
    const reach = isRing ? this.handles.radius(component) : 0;
    const held = { component, value, axis, origin, reach, isRing, isEdgeOn, last: 0, pointer: event.pointerId };
    const from = this.measure(event, held);
    this.held = from === null ? null : { ...held, from };
    return this.isOn;
  }

  /**
   * What the mouse means now; null where it means nothing.
   * @param {PointerEvent} event
   */
  move(event) {
    const { held } = this, now = held && this.measure(event, held);
    if (!held || now === null) return null;
    const { component, value } = held, moved = movedBy(held, now);
    const step = stepOf(component, event);
    return { component, value: snapped(component, value + moved, step), step };
  }

  end() { this.held = null; }

  /**
   * What the mouse is at.
   * @param {PointerEvent} event
   * @param {Omit<Held, "from">} held
   * @returns {Where | null}
   */
  measure(event, { axis, origin, reach, isRing, isEdgeOn }) {
    const ray = rayOf(this.viewer, event);
    if (!isRing) return alongLine(ray, origin, axis);
    if (!isEdgeOn) return onPlane(ray, origin, axis);
    const across = new Vector3().crossVectors(axis, ray.direction).normalize();
    const along = alongLine(ray, origin, across);
    return along === null ? null : -along / reach;
  }
}

/**
 * How far a number has moved from where the drag began; of a ring more than a turn too.
 * @param {Held} held
 * @param {Where} now
 */
function movedBy(held, now) {
  const { from } = held;
  if (typeof now === "number" || typeof from === "number") return Number(now) - Number(from);
  const angle = angleBetween(held.axis, held.origin, from, now);
  held.last += wrappedAngle(angle - held.last);
  return held.last;
}
