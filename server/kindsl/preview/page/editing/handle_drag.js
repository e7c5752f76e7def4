// A press on a handle, until it is let go: which value the mouse means. Shift snaps finely, Ctrl not at all.
import { alongLine, angleBetween, onPlane, rayOf, wrappedAngle } from "./rays.js";

const { Vector3 } = MeshCat.THREE;
const DEGREE = Math.PI / 180;
const STEPS = { length: [0.01, 0.001], angle: [15 * DEGREE, 5 * DEGREE] };
const FREE = { length: 1e4, angle: 1e3 }; // parts of a metre, of a radian, that a free value is told in
const GRAZING = 0.2; // below this a ring is seen from its edge

export const unitOf = (component) => (component.length === 2 ? "angle" : "length");

// What a value is to be a multiple of; null for any value.
export const stepOf = (component, { shiftKey, ctrlKey, metaKey }) =>
  ctrlKey || metaKey ? null : STEPS[unitOf(component)][shiftKey ? 1 : 0];

export function snapped(component, value, step) {
  const parts = FREE[unitOf(component)];
  return step === null ? Math.round(value * parts) / parts : step * Math.round(value / step);
}

export class HandleDrag {
  constructor(viewer, handles) { Object.assign(this, { viewer, handles, held: null }); }

  get isOn() { return this.held !== null; }

  // Whether an event is of the finger or mouse that holds the handle.
  holds({ pointerId }) { return this.isOn && this.held.pointer === pointerId; }

  // Whether a handle could be taken; `value` is its number now.
  begin(component, value, event) {
    const geometry = this.handles.geometry();
    if (!geometry) return false;
    const axis = geometry.axes[component].clone(), origin = geometry.origin.clone();
    const ray = rayOf(this.viewer, event), isRing = component.length === 2;
    const isEdgeOn = isRing && Math.abs(ray.direction.dot(axis)) < GRAZING;
    const reach = isRing ? this.handles.radius(component) : 0;
    this.held = { component, value, axis, origin, reach, isRing, isEdgeOn, last: 0, pointer: event.pointerId };
    this.held.from = this.measure(event);
    if (this.held.from === null) this.held = null;
    return this.isOn;
  }

  // {component, value, step} that the mouse means now; null where it means nothing.
  move(event) {
    const { component, value, from, isRing, isEdgeOn } = this.held, now = this.measure(event);
    if (now === null) return null;
    let moved;
    if (isRing && !isEdgeOn) {
      const angle = angleBetween(this.held.axis, this.held.origin, from, now);
      this.held.last += wrappedAngle(angle - this.held.last);
      moved = this.held.last;
    } else moved = now - from;
    const step = stepOf(component, event);
    return { component, value: snapped(component, value + moved, step), step };
  }

  end() { this.held = null; }

  // What the mouse is at: a distance along an arrow, a place in a ring's plane; of a ring on edge the angle that
  // its near side rolls by.
  measure(event) {
    const { axis, origin, reach, isRing, isEdgeOn } = this.held, ray = rayOf(this.viewer, event);
    if (!isRing) return alongLine(ray, origin, axis);
    if (!isEdgeOn) return onPlane(ray, origin, axis);
    const across = new Vector3().crossVectors(axis, ray.direction).normalize();
    const along = alongLine(ray, origin, across);
    return along === null ? null : -along / reach;
  }
}
