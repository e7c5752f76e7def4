// What is under the mouse: hovering names it, a click reveals it in the source.

const CLICK_TOLERANCE = 4; // pixels that the mouse may move in a click

export class Picking {
  constructor(scene, pane, actions) {
    this.scene = scene;
    this.canvas = scene.viewer.renderer.domElement;
    this.tip = document.createElement("div");
    this.tip.className = "tip";
    this.tip.hidden = true;
    pane.append(this.tip);
    this.actions = actions;
    this.canvas.addEventListener("pointermove", (event) => this.hover(event));
    this.canvas.addEventListener("pointerleave", () => this.show(null));
    this.canvas.addEventListener("pointerdown", (event) => { this.pressed = [event.clientX, event.clientY]; });
    // The viewer's controls capture the pointer, so its release comes to the pane.
    pane.addEventListener("pointerup", (event) => this.release(event));
  }

  hover(event) {
    if (event.buttons || event.pointerType === "touch") return this.show(null);
    const found = this.at(event);
    this.show(found, event);
    this.actions.hover(found && { kind: found.kind, name: found.name });
  }

  show(found, event) {
    this.tip.hidden = !found;
    this.canvas.style.cursor = found ? "pointer" : "";
    if (!found) return;
    this.tip.textContent = `${found.kind} ${found.name}`;
    this.tip.style.transform = `translate(${event.offsetX + 14}px, ${event.offsetY + 14}px)`;
  }

  release(event) {
    const [x, y] = this.pressed || [NaN, NaN];
    this.pressed = null;
    const isClick = Math.hypot(event.clientX - x, event.clientY - y) <= CLICK_TOLERANCE;
    if (!isClick || event.button !== 0) return;
    const found = this.at(event);
    if (found) this.actions.reveal({ kind: found.kind, name: found.name });
    else this.actions.clear();
  }

  // The nearest owner under the mouse; small marks win over the bodies that enclose them.
  at(event) {
    const box = this.canvas.getBoundingClientRect();
    const point = new MeshCat.THREE.Vector2(
      (2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height);
    const ray = new MeshCat.THREE.Raycaster();
    ray.setFromCamera(point, this.scene.viewer.camera);
    const hits = [];
    for (const { distance, object, instanceId } of ray.intersectObjects(this.scene.batches.meshes, false)) {
      const owner = this.scene.owner(object.userData.marks[instanceId]);
      if (owner) hits.push({ ...owner, distance });
    }
    hits.sort((a, b) => a.pick - b.pick || a.distance - b.distance);
    return hits[0] || null;
  }
}
