// What the page's parts say to each other, and what of meshcat's viewer they use.
import type * as THREE from "three";
import type { FrameMessage, JointMessage, LinkMessage, ParameterMessage, SolidMessage } from "../messages.js";

/** Metres, or without a unit. */
export type Vector = readonly [number, number, number];
/** Homogeneous, 16 numbers, column by column (three.js' order). */
export type Matrix = readonly number[];

export type Kind = "link" | "joint" | "frame";
export type Group = `${Kind}s`;
/** A link, joint or frame. */
export interface Thing {
  readonly kind: Kind;
  readonly name: string;
}

/** A robot, or the ghost of one, by names. */
export interface Tree {
  readonly links: Map<string, LinkMessage>;
  readonly joints: Map<string, JointMessage>;
  readonly frames: Map<string, FrameMessage>;
  /** By links. */
  readonly solids: Map<string, SolidMessage>;
}
/** `base_T_thing` of all things of a tree, by names. */
export type Poses = Readonly<Record<Group, Map<string, Matrix>>>;

/** Hexadecimal colours, 0xrrggbb, by what they are of. */
export type Colors = Readonly<Record<string, number>>;
/** How a kind of thing is shown. */
export interface Look {
  readonly visible: boolean;
  readonly opacity: number;
}
/** From where the robot is seen, in the base's frame, metres. */
export interface Eye {
  readonly position: Vector;
  readonly target: Vector;
}

/** The geometry and look that marks share. */
export interface MarkShape {
  readonly key: string;
  readonly geometry: THREE.BufferGeometry;
  readonly isLit: boolean;
  readonly isOnTop: boolean;
}
/** Something small that is drawn: a rod, a ball, an arrow. */
export interface Mark {
  readonly path: string;
  readonly tree: "robot" | "ghost";
  readonly group: Group | "total";
  readonly name: string;
  readonly category: string;
  readonly part: string;
  readonly shape: MarkShape;
  /** Its place and size under its thing. */
  local: THREE.Matrix4;
}

/** A named value, as it is sent to the server. */
export type NamedValue = Pick<ParameterMessage, "name" | "value">;

/** What the user can do, whatever it is done with: mouse, touch, keyboard, panel or picture. */
export interface Actions {
  /** Whether there is no server. */
  readonly isStatic: boolean;
  /** Remember how things are now, for undoing and in the address. */
  note(): void;
  setJoint(name: string, value: number): void;
  /** Several joints at once, by name. */
  setPose(values: ReadonlyMap<string, number>): void;
  /** Tell the server. */
  tellPose(values: readonly (readonly [string, number])[]): void;
  zero(): void;
  /** Null takes the value back that was set here. */
  setParameter(name: string, value: number | null): void;
  setParameters(parameters: readonly NamedValue[]): void;
  writeParameters(parameters: readonly NamedValue[]): void;
  setView(key: string, visible: boolean, opacity: number): void;
  choosePreset(name: string): void;
  resetPreset(): void;
  showOversized(isShown: boolean): void;
  chooseTheme(choice: string): void;
  hover(thing: Thing | null): void;
  /** Choose a thing and show its place in the text; of findings and parameters only the place. */
  reveal(thing: { readonly kind: Kind | "finding" | "parameter"; readonly name: string }): void;
  clear(): void;
  frame(): void;
  focus(): void;
  /** Null for all joints. */
  animate(name: string | null): void;
  measure(): void;
  savePicture(): void;
  copyLink(): void;
  showKeys(): void;
  foldPanel(isFolded?: boolean): void;
}

export type { Request } from "../messages.js";

/** meshcat's viewer, as far as we use it. */
export interface Viewer {
  readonly scene: THREE.Scene;
  readonly camera: THREE.PerspectiveCamera;
  readonly renderer: THREE.WebGLRenderer;
  readonly controls: Controls;
  readonly gui: { readonly domElement: HTMLElement };
  readonly scene_tree: SceneNode & { folder: unknown };
  handle_command(message: unknown): void;
  handle_command_bytearray(frame: Uint8Array): void;
  set_dirty(): void;
  render(): void;
  set_3d_pane_size(): void;
  hide_background(): void;
  set_property(path: readonly string[], name: string, value: unknown): void;
  delete_path(path: readonly string[]): void;
}
/** three.js' OrbitControls. */
export interface Controls extends THREE.EventDispatcher {
  readonly target: THREE.Vector3;
  enabled: boolean;
  minDistance: number;
  maxDistance: number;
  update(): void;
}
export interface SceneNode {
  readonly object: THREE.Object3D;
  readonly children: Record<string, SceneNode>;
  find(path: readonly string[]): SceneNode;
}

declare global {
  /** The plot's script, too. */
  const uPlot: new (options: object, data: readonly (readonly number[])[], holder: HTMLElement) => {
    setCursor(at: object): void;
    setSize(size: object): void;
    destroy(): void;
    valToPos(value: number, scale: string): number;
  };
  /** The viewer's script, which comes before ours. */
  const MeshCat: {
    readonly THREE: typeof THREE;
    readonly Viewer: new (pane: HTMLElement) => Viewer;
  };
}
