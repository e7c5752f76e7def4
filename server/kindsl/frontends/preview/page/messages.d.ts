// Messages between server and page. Generated from server/kindsl/robots/scene/messages.py and
// server/kindsl/frontends/preview/requests.py by
// `python -m generating.message_types`; do not edit.
//
// Numbers that are not finite may come as null in JSON.

/** A shape as three.js' ObjectLoader reads it. Equal shapes have equal identifiers. */
export interface ShapeObject {
  readonly metadata: { readonly version: number; readonly type: string };
  readonly geometries: readonly { readonly uuid: string; readonly type: string }[];
  readonly materials: readonly {
    readonly uuid: string;
    readonly type: string;
    readonly color: number;
  }[];
  readonly object: {
    readonly uuid: string;
    readonly type: string;
    readonly geometry: string;
    readonly material: string;
    readonly matrix: readonly number[];
  };
}

/** Draw a shape. */
export interface SetObject {
  readonly type: "set_object";
  readonly path: string;
  /** In meshcat's form. */
  readonly object: ShapeObject;
}

/** Place and stretch a mark in the frame of its link, joint or frame. */
export interface SetTransform {
  readonly type: "set_transform";
  readonly path: string;
  /** 16 numbers, column by column. */
  readonly matrix: readonly number[];
}

/** Forget a path and all below it. */
export interface Delete {
  readonly type: "delete";
  readonly path: string;
}

/** The robot as a whole, at its zero configuration. */
export interface ModelMessage {
  readonly type: "model";
  readonly name: string;
  /** Whether its base moves freely. */
  readonly is_floating: boolean;
  /** Diagonal of the box around all bodies, metres. */
  readonly size: number;
  /** Middle of that box in the base's frame, metres. */
  readonly center: readonly [number, number, number];
  /** Height of the ground in the base's frame, metres. */
  readonly ground: number;
  /** Radius to draw bodies with; marks are made for a radius of 1, metres. */
  readonly unit: number;
  /** Of most of its links, kilograms per cubic metre. */
  readonly density: number;
  readonly path: string;
}

/** A link's numbers, the base's among them; points are in its frame. */
export interface LinkMessage {
  readonly type: "link";
  readonly path: string;
  readonly name: string;
  /** 0 for the base; parents come before their children. */
  readonly index: number;
  /** The supporting joint, empty for the base. */
  readonly joint: string;
  /** Kilograms. */
  readonly mass: number;
  /** Centre of mass, metres. */
  readonly com: readonly [number, number, number];
  /** About the CoM in the link's axes, row by row, kg m^2. */
  readonly inertia: readonly number[];
  /** Whether a rigid body with such an inertia exists. */
  readonly is_consistent: boolean;
  /** Why mass, CoM or moments are not known; empty where they are. */
  readonly lacks: string;
  /** Where its name stands, metres. */
  readonly anchor: readonly [number, number, number];
  /** Where it reaches to, metres. */
  readonly ends: readonly (readonly [number, number, number])[];
}

/** A superquadric of uniform density. */
export interface Core {
  /** In the link's frame, metres. */
  readonly center: readonly [number, number, number];
  /** Three right-handed unit vectors; the last is the pole. */
  readonly axes: readonly number[];
  /** Along the axes, metres. */
  readonly semi_axes: readonly [number, number, number];
  /** Radii of gyration along the axes, as drawn exactly, metres. */
  readonly gyration: readonly [number, number, number];
  /** Along meridians and parallels: 1 is round, near 0 is square. */
  readonly exponents: readonly [number, number];
  /** Kilograms per cubic metre. */
  readonly density: number;
  /** Scale of a shell of the robot's usual density that has the same mass and inertia; 1 where the solid is as dense. */
  readonly shell: number;
}

/** What the linter says of a body's numbers. */
export interface Doubt {
  /** Of the rule that reports it. */
  readonly code: string;
  /** For people. */
  readonly sentence: string;
  /** Whether it is an error, else a warning. */
  readonly is_error: boolean;
}

/** A straight piece of a body, from its frame's origin. */
export interface Segment {
  /** The joint or frame that it goes to, else `com`. */
  readonly name: string;
  /** In the body's frame, metres. */
  readonly end: readonly [number, number, number];
}

/** A link as a body: the uniform solid with its inertia, and bones to its joints. */
export interface SolidMessage {
  readonly type: "solid";
  readonly path: string;
  /** The link's. */
  readonly name: string;
  /** Null where there is no solid to draw. */
  readonly core: Core | null;
  /** `glass` would hide the robot, `doubtful` and `impossible` are judged. */
  readonly look: "sound" | "glass" | "doubtful" | "impossible";
  /** What the linter says of it, the gravest first. */
  readonly doubts: readonly Doubt[];
  /** Whether it is too large to be drawn unless asked for. */
  readonly is_oversized: boolean;
  /** To its joints and frames. */
  readonly bones: readonly Segment[];
  /** Of the bones, metres. */
  readonly radius: number;
  /** From a bone to the CoM, two points; else empty. */
  readonly strut: readonly (readonly [number, number, number])[];
  /** Radius of the supporting joint's drum, metres. */
  readonly drum: number;
  /** Whether a shade tells it from its parent. */
  readonly is_shaded: boolean;
}

/** A joint and its place; it turns about its z axis or slides along it. */
export interface JointMessage {
  readonly type: "joint";
  readonly path: string;
  readonly name: string;
  /** Of the link that it supports. */
  readonly index: number;
  readonly kind: "revolute" | "prismatic";
  /** The parent link. */
  readonly predecessor: string;
  /** The child link. */
  readonly successor: string;
  /** Its frame in the parent link's frame, 16 numbers, column by column. */
  readonly placement: readonly number[];
  /** Whether its place is in part a guess. */
  readonly is_guess: boolean;
}

/** An optional frame and its place. */
export interface FrameMessage {
  readonly type: "frame";
  readonly path: string;
  /** After the link's name and a dot where the name is taken. */
  readonly name: string;
  /** The link that it is attached to. */
  readonly link: string;
  /** Its place in the link's frame, 16 numbers, column by column. */
  readonly placement: readonly number[];
  /** Whether its place is in part a guess. */
  readonly is_guess: boolean;
}

/** The limits of a joint; null where there is none. */
export interface LimitsMessage {
  readonly type: "limits";
  readonly path: string;
  readonly name: string;
  readonly minimum: number | null;
  readonly maximum: number | null;
}

/** The position of a joint. */
export interface ValueMessage {
  readonly type: "value";
  readonly path: string;
  readonly name: string;
  /** Radians or metres. */
  readonly value: number;
}

/** A pose that the configuration names. */
export interface PoseMessage {
  readonly type: "pose";
  readonly path: string;
  readonly name: string;
  /** Positions by joint; the other joints are at zero. */
  readonly joints: { readonly [name: string]: number };
}

/** A parameter's row in the panel. */
export interface ParameterMessage {
  readonly type: "parameter";
  readonly path: string;
  /** Its place among the document's parameters. */
  readonly index: number;
  readonly name: string;
  readonly kind: "dynamics" | "length" | "angle";
  /** As drawn, metres, radians or kg, kg m, kg m^2. */
  readonly value: number;
  /** Whether the value is a guess because there is none. */
  readonly is_guess: boolean;
  /** Whether a configuration gives it its value. */
  readonly is_bound: boolean;
  /** Of its slider, metres, radians or kg, kg m, kg m^2. */
  readonly minimum: number;
  /** Of its slider, metres, radians or kg, kg m, kg m^2. */
  readonly maximum: number;
  /** Whether a configuration gives minimum and maximum. */
  readonly has_range: boolean;
  /** Whether the value was set in the page. */
  readonly is_overridden: boolean;
}

/** A motion to be played. */
export interface TrajectoryMessage {
  readonly type: "trajectory";
  /** Of its file. */
  readonly name: string;
  /** Of its file, CSV or JSON. */
  readonly text: string;
  readonly path: string;
}

/** A place as a formula of parameters, for pages without a server. */
export interface FormulaMessage {
  readonly type: "formula";
  readonly path: string;
  readonly group: "joints" | "frames";
  readonly name: string;
  /** The link that it is attached to. */
  readonly link: string;
  /** X, y, z in the link's frame, metres. */
  readonly translation: readonly (readonly [number, readonly (readonly [string, number])[]])[];
  /** Intrinsic angles about x, y, z, radians. */
  readonly rotation: readonly (readonly [number, readonly (readonly [string, number])[]])[];
  /** Path of the link's mark that reaches there. */
  readonly rod: string;
  /** Path of the mark at that rod's end. */
  readonly end: string;
}

/** The robot that stands behind the document's: as last saved, another, or as planned. */
export interface GhostMessage {
  readonly type: "ghost";
  readonly kind: "saved" | "other" | "planned";
  /** Of its file; empty if it has none. */
  readonly name: string;
  readonly path: string;
}

/** Another description of the robot that can be compared. */
export interface OtherMessage {
  readonly type: "other";
  readonly path: string;
  /** Its place in the list. */
  readonly index: number;
  /** Of its file. */
  readonly name: string;
  /** Whether it is compared now. */
  readonly is_chosen: boolean;
}

/** A number that differs in the other file. */
export interface DifferenceRow {
  /** `link`, `joint` or `frame`. */
  readonly kind: string;
  /** In the document, or of the link that it belongs to. */
  readonly name: string;
  /** Whose number it is, as its file calls it. */
  readonly owner: string;
  /** `mass`, `CoM x`, `Ixx`, `x`, `rx`, .... */
  readonly quantity: string;
  /** Of both values. */
  readonly unit: string;
  /** In the document. */
  readonly here: number;
  /** In the other file. */
  readonly there: number;
  /** With the lines, for people. */
  readonly message: string;
  /** In the document, counts from 1; 0 where it does not stand there. */
  readonly line: number;
}

/** The result of comparing the document with another file. */
export interface ComparisonMessage {
  readonly type: "comparison";
  /** Name of the document. */
  readonly own: string;
  /** Name of the other file. */
  readonly other: string;
  /** In words; why it cannot be compared where it cannot. */
  readonly verdict: string;
  /** Whether the mechanics are equal. */
  readonly is_equal: boolean;
  /** The numbers that differ. */
  readonly rows: readonly DifferenceRow[];
  /** Other differences, one sentence each. */
  readonly structure: readonly string[];
  /** Differences without any meaning for the mechanics, one sentence each. */
  readonly conventions: readonly string[];
  readonly path: string;
}

/** A shape that another description gives a link for drawing. */
export interface VisualMessage {
  readonly type: "visual";
  readonly path: string;
  readonly link: string;
  readonly form: "mesh" | "box" | "cylinder" | "sphere";
  /** Factors of a mesh along its axes; sides of a box, radius and length of a cylinder along z, radius of a sphere, metres. */
  readonly size: readonly number[];
  /** Its frame in the link's, 16 numbers, column by column. */
  readonly matrix: readonly number[];
  /** Name of a mesh's file at the server, with its suffix; else empty. */
  readonly file: string;
}

/** The content of a mesh's file, for pages without a server. */
export interface MeshDataMessage {
  readonly type: "mesh_data";
  readonly path: string;
  /** Its name in `visual` messages. */
  readonly file: string;
  /** Its bytes in base 64. */
  readonly data: string;
}

/** The description whose meshes can be drawn. */
export interface MeshesMessage {
  readonly type: "meshes";
  /** Of its file. */
  readonly name: string;
  /** Whether they have been asked for, so that there are `visual`s. */
  readonly is_loaded: boolean;
  /** What is left out and why, one sentence each. */
  readonly problems: readonly string[];
  readonly path: string;
}

/** A finding of the linter, in the list over the picture. */
export interface FindingMessage {
  readonly type: "finding";
  readonly path: string;
  /** Its place in the list, the worst first. */
  readonly index: number;
  /** Of the rule: `KD301`. */
  readonly code: string;
  /** `error`, `warning`, `info` or `hint`. */
  readonly severity: string;
  /** For people. */
  readonly message: string;
  /** Counts from 1. */
  readonly line: number;
  /** Counts from 1, in code points. */
  readonly column: number;
}

/** The picture's relation to the document. */
export interface StatusMessage {
  readonly type: "status";
  /** `gone` if the document cannot be read. */
  readonly state: "live" | "broken" | "guessed" | "gone";
  /** On the state; empty if all is well, for people. */
  readonly message: string;
  /** Number of findings, listed or not. */
  readonly total: number;
  /** Number of findings by severity. */
  readonly counts: { readonly [name: string]: number };
  /** Name of the document. */
  readonly label: string;
  /** Of all bodies that count, as far as known, kilograms. */
  readonly mass: number;
  /** Why that is not all; empty where it is. */
  readonly lacks: string;
  /** Whether an earlier version is drawn. */
  readonly is_former: boolean;
  readonly path: string;
}

/** The thing at the editor's cursor; empty for nothing. */
export interface HighlightMessage {
  readonly type: "highlight";
  /** `link`, `joint` or `frame`. */
  readonly kind: string;
  readonly name: string;
  readonly path: string;
}

/** The permission to edit the document from the page. */
export interface EditingMessage {
  readonly type: "editing";
  /** Of the text that is shown; sent back with each drag. */
  readonly revision: number;
  readonly path: string;
}

/** One number of a thing. */
export interface Handle {
  /** `x y z rx ry rz`. */
  readonly component: string;
  /** Null where it has none. */
  readonly value: number | null;
  /** As written in the document. */
  readonly text: string;
  /** Parameter or constant that carries it, empty for a plain number. */
  readonly symbol: string;
  /** Other places that the symbol moves. */
  readonly moves_along: readonly string[];
  /** Why it cannot be changed, empty where it can. */
  readonly locked: string;
}

/** The numbers of the thing that is grasped. */
export interface HandlesMessage {
  readonly type: "handles";
  /** `joint`, `frame` or `com`. */
  readonly kind: string;
  /** Of a centre of mass the link's. */
  readonly name: string;
  /** Of the text that they are of. */
  readonly revision: number;
  /** Optional frame along whose axes a CoM is written, empty for its link's. */
  readonly frame: string;
  /** Three of a centre of mass, else six. */
  readonly components: readonly Handle[];
  /** Whether its link has a counterpart that the document lacks. */
  readonly can_mirror: boolean;
  readonly path: string;
}

/** The result of a handle's move. */
export interface DraggedMessage {
  readonly type: "dragged";
  /** As requested: `move`, `drop` or `cancel`. */
  readonly phase: string;
  /** `x y z rx ry rz`. */
  readonly component: string;
  /** The number as it is or would be written. */
  readonly text: string;
  /** Of that number, radians or metres. */
  readonly value: number;
  /** Why not; empty if nothing was in the way. */
  readonly reason: string;
  /** Whether the document was changed. */
  readonly written: boolean;
  /** Which body becomes impossible; empty for none. */
  readonly warning: string;
  readonly path: string;
}

/** The preview of a gesture. */
export interface PlanMessage {
  readonly type: "plan";
  /** As requested. */
  readonly gesture: string;
  /** In the imperative; empty if it cannot be done. */
  readonly title: string;
  /** Why not; empty if nothing is in the way. */
  readonly reason: string;
  readonly path: string;
}

/** The result of an accepted gesture. */
export interface WrittenMessage {
  readonly type: "written";
  /** As requested. */
  readonly gesture: string;
  /** In the imperative. */
  readonly title: string;
  /** Why nothing was written; empty if it was. */
  readonly reason: string;
  readonly path: string;
}

/** Lines that the user may add to a file. */
export interface LinesMessage {
  readonly type: "lines";
  readonly text: string;
  readonly path: string;
}

/** The answer to a message that is no request. */
export interface RefusedMessage {
  readonly type: "refused";
  /** For people. */
  readonly reason: string;
  readonly path: string;
}

/** One atomic update of the page. */
export interface Change {
  readonly type: "change";
  /** Whether this is the whole state, and all else is gone. */
  readonly is_whole: boolean;
  /** In the order in which they are to be taken. */
  readonly parts: readonly Part[];
}

/** Move joints. */
export interface SetJoints {
  readonly type: "set-joints";
  /** By name. */
  readonly values: { readonly [name: string]: number };
}

/** Give parameters values in the picture only, or their own back for null. */
export interface SetParameters {
  readonly type: "set-parameters";
  /** By name. */
  readonly values: { readonly [name: string]: number | null };
}

/** Give parameters these values in the configuration file. */
export interface WriteParameters {
  readonly type: "write-parameters";
  /** By name. */
  readonly values: { readonly [name: string]: number };
}

/** Give a pose a name in the configuration file. */
export interface KeepPose {
  readonly type: "keep-pose";
  readonly name: string;
  /** Positions by joint. */
  readonly values: { readonly [name: string]: number };
}

/** Show the source of a thing. */
export interface Reveal {
  readonly type: "reveal";
  readonly kind: "link" | "joint" | "frame" | "parameter" | "finding";
  /** Of a finding its number in the list. */
  readonly name: string;
}

/** Compare with another file that was offered; with none for an empty name. */
export interface Compare {
  readonly type: "compare";
  readonly name: string;
}

/** Greet the server, maybe with values from before it was restarted. */
export interface Hello {
  readonly type: "hello";
  /** By name. */
  readonly joints?: { readonly [name: string]: number };
  /** By name. */
  readonly parameters?: { readonly [name: string]: number };
}

/** Show the handles of a joint, frame or centre of mass; none for an empty name. */
export interface Grasp {
  readonly type: "grasp";
  readonly kind: "joint" | "frame" | "com" | "";
  readonly name: string;
}

/** Move a handle. */
export interface Drag {
  readonly type: "drag";
  readonly kind: "joint" | "frame" | "com";
  readonly name: string;
  readonly component: "x" | "y" | "z" | "rx" | "ry" | "rz";
  /** Radians or metres. */
  readonly value: number;
  readonly phase: "move" | "drop" | "cancel";
  /** Of the text that the page shows. */
  readonly revision: number;
  /** The value becomes a multiple of this; null for any. */
  readonly step?: number | null;
  /** Whether the moments of a centre of mass move along. */
  readonly carries?: boolean;
}

/** Add or rewrite something as a whole; undo or redo what was written, discard a plan. */
export interface Plan {
  readonly type: "plan";
  readonly gesture: "add-frame" | "add-child" | "mirror-leg" | "pose-as-zero" | "undo" | "redo" | "discard";
  /** Of the text that the page shows. */
  readonly revision: number;
  /** Of the link; empty for a pose. */
  readonly name?: string;
  /** Where, in the link's frame, metres. */
  readonly point?: readonly [number, number, number];
  /** Of a pose, by name. */
  readonly joints?: { readonly [name: string]: number };
  /** Whether to write it, not only to show it. */
  readonly accepted?: boolean;
}

/** One piece of news. */
export type Part =
  | SetObject
  | SetTransform
  | Delete
  | ModelMessage
  | LinkMessage
  | SolidMessage
  | JointMessage
  | FrameMessage
  | LimitsMessage
  | ValueMessage
  | PoseMessage
  | ParameterMessage
  | TrajectoryMessage
  | FormulaMessage
  | GhostMessage
  | OtherMessage
  | ComparisonMessage
  | VisualMessage
  | MeshDataMessage
  | MeshesMessage
  | FindingMessage
  | StatusMessage
  | HighlightMessage
  | EditingMessage
  | HandlesMessage
  | DraggedMessage
  | PlanMessage
  | WrittenMessage
  | LinesMessage
  | RefusedMessage;

/** What the page asks for. */
export type Request =
  | SetJoints
  | SetParameters
  | WriteParameters
  | KeepPose
  | Reveal
  | Compare
  | ShowMeshes
  | Hello
  | Grasp
  | Drag
  | Plan;
