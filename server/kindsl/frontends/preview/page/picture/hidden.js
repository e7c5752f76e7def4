// Which links the user has closed the eye of, or isolated: their joints and frames go with them.

/** @import { Group, Mark, Tree } from "../base/types.js" */

export class Hidden {
  /** @type {Set<string>} */
  links = new Set();
  /**
   * A link's name.
   * @type {string | null}
   */
  isolated = null;
  version = 0;
  /**
   * The links that joints and frames go with, by name.
   * @type {Readonly<Record<"joints" | "frames", Map<string, string>>>}
   */
  #owners = { joints: new Map(), frames: new Map() };

  /** @param {string} link */
  isHidden(link) {
    return this.isolated === null ? this.links.has(link) : this.isolated !== link;
  }

  /** @param {string} link */
  toggle(link) {
    if (!this.links.delete(link)) this.links.add(link);
    this.version += 1;
  }

  /**
   * Show this link alone, and all again the second time.
   * @param {string} link
   */
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

  /**
   * Tell of each joint and frame which link it goes with.
   * @param {Tree} robot
   */
  learn({ joints, frames }) {
    this.#owners = {
      joints: new Map([...joints.values()].map(({ name, successor }) => [name, successor])),
      frames: new Map([...frames.values()].map(({ name, link }) => [name, link])),
    };
    this.version += 1;
  }

  /** @param {Mark} mark */
  hides({ tree, group, name }) {
    return !this.isEmpty && tree === "robot" && this.hidesThing(group, name);
  }

  /** @param {Group | "total"} group @param {string} name */
  hidesThing(group, name) {
    if (this.isEmpty || group === "total") return false;
    return this.isHidden(group === "links" ? name : this.#owners[group].get(name) ?? "");
  }
}
