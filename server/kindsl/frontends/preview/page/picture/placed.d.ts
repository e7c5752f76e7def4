// What marks are placed and drawn by: the scene, as those see it that it is made of.
import type * as THREE from "three";
import type { Colors, Look, Mark, Poses, Tree, Vector, Viewer } from "../base/types.js";
import type { ModelMessage } from "../messages.js";
import type { Compared } from "./beside.js";
import type { Hidden } from "./hidden.js";
import type { Marks } from "./marks.js";

export interface Placed {
  readonly model: Pick<ModelMessage, "is_floating" | "size" | "unit">;
  readonly poses: Readonly<Record<"robot" | "ghost", Poses>>;
  readonly q: ReadonlyMap<string, number>;
  /** Of the whole robot, in the base's frame; null where it is not known. */
  readonly com: Vector | null;
  /** By joints, N m or N. */
  readonly torques: ReadonlyMap<string, number>;
  readonly largestTorque: number;
  readonly showsOversized: boolean;
  readonly compared: Compared;
  readonly marks: Marks;
  isGuess(mark: Pick<Mark, "tree" | "part">): boolean;
}

/** What bodies are drawn by. */
export interface Pictured extends Omit<Placed, "marks"> {
  readonly viewer: Viewer;
  readonly trees: Readonly<Record<"robot" | "ghost", Tree>>;
  readonly hidden: Hidden;
  readonly meshes: { covers(link: string): boolean; readonly version: number };
  readonly view: ReadonlyMap<string, Look>;
  readonly colors: Colors;
  lookOf(key: string): Look;
  isLit(mark: Pick<Mark, "tree" | "group" | "name" | "category">): boolean;
}

export interface Drawn extends Placed {
  readonly viewer: Viewer;
  readonly bodies: { readonly isOn: boolean };
  readonly hidden: Hidden;
  readonly view: ReadonlyMap<string, Look>;
  readonly colors: Colors;
  colorOf(mark: Mark): number;
  placeMark(mark: Mark, matrix: THREE.Matrix4): void;
}
