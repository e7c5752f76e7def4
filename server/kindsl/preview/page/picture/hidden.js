// Which links the user has closed the eye of, or isolated: their joints and frames go with them.

export class Hidden {
  constructor() {
    this.links = new Set();
    this.isolated = null; // a link's name
    this.version = 0;
  }

  isHidden(link) {
    return this.isolated === null ? this.links.has(link) : this.isolated !== link;
  }

  toggle(link) {
    if (!this.links.delete(link)) this.links.add(link);
    this.version += 1;
  }

  // Show this link alone, and all again the second time.
  isolate(link) {
    this.isolated = this.isolated === link ? null : link;
    this.version += 1;
  }

  showAll() {
    this.links.clear();
    this.isolated = null;
    this.version += 1;
  }

  get isEmpty() { return this.links.size === 0 && this.isolated === null; }

  // Tell of each joint and frame which link it goes with.
  learn({ joints, frames }) {
    this.owners = { links: null, joints: new Map(), frames: new Map() };
    for (const joint of joints.values()) this.owners.joints.set(joint.name, joint.successor);
    for (const frame of frames.values()) this.owners.frames.set(frame.name, frame.link);
    this.version += 1;
  }

  hides({ tree, group, name }) {
    return !this.isEmpty && tree === "robot" && this.hidesThing(group, name);
  }

  hidesThing(group, name) {
    if (this.isEmpty || group === "total") return false;
    const owners = this.owners && this.owners[group];
    return this.isHidden(owners ? owners.get(name) : name);
  }
}
