// Moves one joint, or all of them, to and fro between their limits.

const PERIOD = 4000; // milliseconds

export class Motion {
  // `range(joint)` returns [minimum, maximum]; `onStop()` is called when it comes to rest.
  constructor(scene, { range, onStep, onStop }) {
    Object.assign(this, { scene, range, onStep, onStop, moved: null });
    this.button = document.getElementById("animate");
  }

  // Start or stop; `name` is a joint's, null means all.
  toggle(name) {
    if (this.moved) return this.stop();
    const joints = [...this.scene.trees.robot.joints.values()].filter((joint) => name === null || joint.name === name);
    this.moved = joints.map((joint) => this.plan(joint));
    this.start = performance.now();
    this.button.ariaPressed = "true";
    requestAnimationFrame((now) => this.step(now));
  }

  // So that each begins where it is.
  plan(joint) {
    const [low, high] = this.range(joint), middle = (low + high) / 2, reach = (high - low) / 2;
    const q = this.scene.q.get(joint.name) || 0;
    return { name: joint.name, middle, reach, phase: Math.asin(Math.min(1, Math.max(-1, (q - middle) / reach))) };
  }

  step(now) {
    if (!this.moved) return;
    const turn = (2 * Math.PI * Math.max(0, now - this.start)) / PERIOD;
    for (const { name, middle, reach, phase } of this.moved) this.scene.q.set(name, middle + reach * Math.sin(turn + phase));
    this.scene.changed("motion");
    this.onStep();
    requestAnimationFrame((later) => this.step(later));
  }

  stop() {
    const moved = this.moved || [];
    this.moved = null;
    this.button.ariaPressed = "false";
    if (moved.length) this.onStop(moved.map(({ name }) => name));
  }
}
