// What the server tells the page. Generated from server/kindsl/robots/scene/messages.py by
// `python -m kindsl.frontends.preview.message_types`; do not edit.
//
// Lengths are in metres, angles in radians, masses in kilograms. A matrix has 16 numbers, column by
// column (three.js' order). What is no finite number may come as null in JSON.

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
  /** Of the mark. */
  readonly path: string;
  /** The shape, in meshcat's form. */
  readonly object: ShapeObject;
}

/** Place a shape. */
export interface SetTransform {
  readonly type: "set_transform";
  /** Of the mark. */
  readonly path: string;
  /** Places and stretches the mark in the frame of its link, joint or frame. */
  readonly matrix: readonly number[];
}

/** Forget a path and all below it. */
export interface Delete {
  readonly type: "delete";
  /** The highest that is gone. */
  readonly path: string;
}

/** The robot as a whole, at its zero configuration. */
export interface ModelMessage {
  readonly type: "model";
  /** The document's. */
  readonly name: string;
  /** Whether its base moves freely. */
  readonly is_floating: boolean;
  /** Diagonal of the box around all bodies, metres. */
  readonly size: number;
  /** Middle of that box in the base's frame, metres. */
  readonly center: readonly [number, number, number];
  /** Height of the ground in the base's frame, metres. */
  readonly ground: number;
  /** Radius to draw bodies with, metres; marks are made for a radius of 1. */
  readonly unit: number;
  /** That most of its links have, kg/m^3. */
  readonly density: number;
  /** Constant. */
  readonly path: string;
}

/** A link's numbers, the base's among them. */
export interface LinkMessage {
  readonly type: "link";
  /** Of the link in its tree. */
  readonly path: string;
  /** In the document. */
  readonly name: string;
  /** 0 for the base; parents come before their children. */
  readonly index: number;
  /** Name of the supporting joint, empty for the base. */
  readonly joint: string;
  /** Kilograms. */
  readonly mass: number;
  /** Centre of mass in the link's frame, metres. */
  readonly com: readonly [number, number, number];
  /** Tensor about the centre of mass in the link's axes, row by row, kg m^2. */
  readonly inertia: readonly number[];
  /** Whether a rigid body with such an inertia exists. */
  readonly is_consistent: boolean;
  /** Why mass, centre of mass or moments are not known; empty where they are. */
  readonly lacks: string;
  /** Where its name stands in its frame, metres. */
  readonly anchor: readonly [number, number, number];
  /** Where it reaches to in its frame, metres. */
  readonly ends: readonly (readonly [number, number, number])[];
}

/** A superquadric of uniform density. */
export interface Core {
  /** In the link's frame, metres. */
  readonly center: readonly [number, number, number];
  /** Three right-handed unit vectors in the link's axes, one after another; the last is the pole. */
  readonly axes: readonly number[];
  /** Along these, metres. */
  readonly semi_axes: readonly [number, number, number];
  /** Radii of gyration along these, metres; what is drawn has them exactly. */
  readonly gyration: readonly [number, number, number];
  /** Along meridians and along parallels: 1 is round, near 0 is square. */
  readonly exponents: readonly [number, number];
  /** kg/m^3. */
  readonly density: number;
  /** How much smaller a shell of the robot's usual density is that has the same mass and inertia, as a factor; 1 where the solid is as dense. */
  readonly shell: number;
}

/** A defect of a body, or a possible one. */
export interface DoubtRow {
  /** A short name of it. */
  readonly word: string;
  /** The rule that reports it. */
  readonly code: string;
  /** For people. */
  readonly sentence: string;
}

/** A strut from a link's origin. */
export interface Bone {
  /** Of the joint or frame that it goes to. */
  readonly name: string;
  /** In the link's frame, metres. */
  readonly end: readonly [number, number, number];
}

/** A link as a body: the uniform solid with its inertia, and bones to its joints. */
export interface SolidMessage {
  readonly type: "solid";
  /** Of the body in its tree. */
  readonly path: string;
  /** The link's. */
  readonly name: string;
  /** The solid; None where there is none to be drawn. */
  readonly core: Core | null;
  /** `glass` would hide the robot, `doubtful` and `impossible` are judged. */
  readonly look: "sound" | "glass" | "doubtful" | "impossible";
  /** Defects, proved or possible, the gravest first. */
  readonly doubts: readonly DoubtRow[];
  /** Whether it is too large to be drawn unless asked for. */
  readonly is_oversized: boolean;
  /** To its joints. */
  readonly bones: readonly Bone[];
  /** Of the bones, metres. */
  readonly radius: number;
  /** From a bone to the centre of mass, two points in the link's frame; else empty. */
  readonly strut: readonly (readonly [number, number, number])[];
  /** Radius of the supporting joint's drum, metres. */
  readonly drum: number;
  /** Whether a shade tells it from its parent. */
  readonly is_shaded: boolean;
}

/** A joint and its place. */
export interface JointMessage {
  readonly type: "joint";
  /** Of the joint in its tree. */
  readonly path: string;
  /** In the document. */
  readonly name: string;
  /** That of the link that it supports. */
  readonly index: number;
  /** It turns about its z, or slides along it. */
  readonly kind: "revolute" | "prismatic";
  /** Name of the parent link. */
  readonly predecessor: string;
  /** Name of the child link. */
  readonly successor: string;
  /** Its frame in the parent link's frame. */
  readonly placement: readonly number[];
  /** Whether its place is in part a guess. */
  readonly is_guess: boolean;
}

/** An optional frame and its place. */
export interface FrameMessage {
  readonly type: "frame";
  /** Of the frame in its tree. */
  readonly path: string;
  /** In the document, after the link's name and a dot where the name is taken. */
  readonly name: string;
  /** Name of the link that it is attached to. */
  readonly link: string;
  /** Its place in the link's frame. */
  readonly placement: readonly number[];
  /** Whether its place is in part a guess. */
  readonly is_guess: boolean;
}

/** The limits of a joint. */
export interface LimitsMessage {
  readonly type: "limits";
  /** Of these limits. */
  readonly path: string;
  /** The joint's. */
  readonly name: string;
  /** Radians or metres; None where there is none. */
  readonly minimum: number | null;
  /** Radians or metres; None where there is none. */
  readonly maximum: number | null;
}

/** The position of a joint. */
export interface ValueMessage {
  readonly type: "value";
  /** Of this value. */
  readonly path: string;
  /** The joint's. */
  readonly name: string;
  /** Radians or metres. */
  readonly value: number;
}

/** A pose that the configuration names. */
export interface PoseMessage {
  readonly type: "pose";
  /** Of this pose. */
  readonly path: string;
  /** In the configuration. */
  readonly name: string;
  /** Positions by the names of joints, radians or metres; the others are zero. */
  readonly joints: { readonly [name: string]: number };
}

/** A motion to be played. */
export interface TrajectoryMessage {
  readonly type: "trajectory";
  /** Of its file. */
  readonly name: string;
  /** The file's, CSV or JSON. */
  readonly text: string;
  /** Constant. */
  readonly path: string;
}

/** A parameter's row in the panel; its numbers are in metres, radians or kg, kg m, kg m^2. */
export interface ParameterMessage {
  readonly type: "parameter";
  /** Of this row. */
  readonly path: string;
  /** Its place among the document's parameters. */
  readonly index: number;
  /** In the document. */
  readonly name: string;
  /** The quantity that it measures. */
  readonly kind: "length" | "angle" | "dynamics";
  /** That is drawn. */
  readonly value: number;
  /** Whether that value is one because there is none. */
  readonly is_guess: boolean;
  /** Whether a configuration gives it its value. */
  readonly is_bound: boolean;
  /** Of its slider. */
  readonly minimum: number;
  /** Of its slider. */
  readonly maximum: number;
  /** Whether a configuration gives both of these. */
  readonly has_range: boolean;
  /** Whether the value was set in the page. */
  readonly is_overridden: boolean;
}

/** A place as a formula of parameters, for pages without a server. */
export interface FormulaMessage {
  readonly type: "formula";
  /** Of this formula. */
  readonly path: string;
  /** Name of the group that is placed. */
  readonly group: "joints" | "frames";
  /** Of the joint or frame. */
  readonly name: string;
  /** Name of the link that it is attached to. */
  readonly link: string;
  /** In the link's frame, a formula for each of x, y, z, metres. */
  readonly translation: readonly (readonly [number, readonly (readonly [string, number])[]])[];
  /** Intrinsic angles about x, y, z, a formula for each, radians. */
  readonly rotation: readonly (readonly [number, readonly (readonly [string, number])[]])[];
  /** Path of the link's mark that reaches there. */
  readonly rod: string;
  /** Path of the mark at that rod's end. */
  readonly end: string;
}

/** A finding of the linter, in the list over the picture. */
export interface FindingMessage {
  readonly type: "finding";
  /** Of this finding. */
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
  /** See there; `gone` if the document cannot be read. */
  readonly state: "live" | "broken" | "guessed" | "gone";
  /** A sentence on the state, for people; empty if all is well. */
  readonly message: string;
  /** How many findings there are, listed or not. */
  readonly total: number;
  /** How many there are of each severity that occurs. */
  readonly counts: { readonly [name: string]: number };
  /** Name of the document. */
  readonly label: string;
  /** Of all bodies that count, as far as known, kilograms. */
  readonly mass: number;
  /** Why that is not all; empty where it is. */
  readonly lacks: string;
  /** Whether an earlier version is drawn. */
  readonly is_former: boolean;
  /** Constant. */
  readonly path: string;
}

/** The thing at the editor's cursor. */
export interface HighlightMessage {
  readonly type: "highlight";
  /** `link`, `joint` or `frame`; empty for nothing. */
  readonly kind: string;
  /** In the document; empty for nothing. */
  readonly name: string;
  /** Constant. */
  readonly path: string;
}

/** The robot that stands behind the document's. */
export interface GhostMessage {
  readonly type: "ghost";
  /** The version that was last saved, another robot that is compared, or what an edit that is planned would make. */
  readonly kind: "saved" | "other" | "planned";
  /** Of its file; empty if it has none. */
  readonly name: string;
  /** Constant. */
  readonly path: string;
}

/** Another description of the robot that can be compared. */
export interface OtherMessage {
  readonly type: "other";
  /** Of this one. */
  readonly path: string;
  /** Its place in the list. */
  readonly index: number;
  /** Of its file. */
  readonly name: string;
  /** Whether it is compared now. */
  readonly is_chosen: boolean;
}

/** A number that is another in the other file. */
export interface DifferenceRow {
  /** `link`, `joint` or `frame`. */
  readonly kind: string;
  /** In the document, or of the link that it belongs to. */
  readonly name: string;
  /** Whose number it is, as its file calls it. */
  readonly owner: string;
  /** `mass`, `CoM x`, `Ixx`, `x`, `rx`, ... */
  readonly quantity: string;
  /** Of both values. */
  readonly unit: string;
  /** In the document. */
  readonly here: number;
  /** In the other file. */
  readonly there: number;
  /** For people, with the lines. */
  readonly message: string;
  /** In the document, counts from 1; 0 where it does not stand there. */
  readonly line: number;
}

/** The result of comparing the document with another file. */
export interface ComparisonMessage {
  readonly type: "comparison";
  /** What to call the document. */
  readonly own: string;
  /** What to call the other file. */
  readonly other: string;
  /** In words; why it cannot be compared where it cannot. */
  readonly verdict: string;
  /** Whether the mechanics are equal. */
  readonly is_equal: boolean;
  /** The numbers that differ. */
  readonly rows: readonly DifferenceRow[];
  /** What else differs, one sentence each. */
  readonly structure: readonly string[];
  /** What differs without any meaning for the mechanics, one sentence each. */
  readonly conventions: readonly string[];
  /** Constant. */
  readonly path: string;
}

/** A shape that another description gives a link for drawing. */
export interface VisualMessage {
  readonly type: "visual";
  /** Of this shape. */
  readonly path: string;
  /** Name of the link. */
  readonly link: string;
  /** What it is. */
  readonly form: "mesh" | "box" | "cylinder" | "sphere";
  /** Factors of a mesh along its axes; sides of a box, radius and length of a cylinder along z, radius of a sphere, metres. */
  readonly size: readonly number[];
  /** Its frame in the link's. */
  readonly matrix: readonly number[];
  /** The name of a mesh's file at the server, which tells its format; else empty. */
  readonly file: string;
}

/** The content of a mesh's file, for pages without a server. */
export interface MeshDataMessage {
  readonly type: "mesh_data";
  /** Of this file. */
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
  /** Whether they have been asked for, so that `visual` messages are there. */
  readonly is_loaded: boolean;
  /** What is left out and why, one sentence each. */
  readonly problems: readonly string[];
  /** Constant. */
  readonly path: string;
}

/** The permission to edit the document from the page. */
export interface EditingMessage {
  readonly type: "editing";
  /** Of the text that is shown; to be sent back with what is dragged. */
  readonly revision: number;
  /** Constant. */
  readonly path: string;
}

/** One number of a thing. */
export interface HandleRow {
  /** `x y z rx ry rz`. */
  readonly component: string;
  /** Metres or radians, None where it has none. */
  readonly value: number | null;
  /** As written in the document. */
  readonly text: string;
  /** The parameter or constant that carries it, empty where it is a plain number. */
  readonly symbol: string;
  /** Other places that the symbol moves: `joint 'knee' x`. */
  readonly moves_along: readonly string[];
  /** Why it cannot be changed, empty where it can. */
  readonly locked: string;
}

/** The numbers of what is grasped. */
export interface HandlesMessage {
  readonly type: "handles";
  /** `joint`, `frame` or `com`. */
  readonly kind: string;
  /** In the document; of a centre of mass the link's. */
  readonly name: string;
  /** Of the text that they are of. */
  readonly revision: number;
  /** Optional frame along whose axes a centre of mass is written, empty for its link's. */
  readonly frame: string;
  /** Three of a centre of mass, else six. */
  readonly components: readonly HandleRow[];
  /** Whether its link has a mirror image that the document lacks. */
  readonly can_mirror: boolean;
  /** Constant. */
  readonly path: string;
}

/** The result of a handle's move. */
export interface DraggedMessage {
  readonly type: "dragged";
  /** That the page asked for: `move`, `drop` or `cancel`. */
  readonly phase: string;
  /** `x y z rx ry rz`. */
  readonly component: string;
  /** The number as it is or would be written. */
  readonly text: string;
  /** That number, metres or radians. */
  readonly value: number;
  /** Why not; empty if nothing was in the way. */
  readonly reason: string;
  /** Whether the document was changed. */
  readonly written: boolean;
  /** Which body it makes impossible; empty for none. */
  readonly warning: string;
  /** Constant. */
  readonly path: string;
}

/** The preview of a gesture. */
export interface PlanMessage {
  readonly type: "plan";
  /** That the page asked for. */
  readonly gesture: string;
  /** Its title, in the imperative; empty if it cannot be. */
  readonly title: string;
  /** Why not; empty if nothing is in the way. */
  readonly reason: string;
  /** Constant. */
  readonly path: string;
}

/** The result of an accepted gesture. */
export interface WrittenMessage {
  readonly type: "written";
  /** That the page asked for. */
  readonly gesture: string;
  /** Its title, in the imperative. */
  readonly title: string;
  /** Why nothing was written; empty if it was. */
  readonly reason: string;
  /** Constant. */
  readonly path: string;
}

/** Lines that the user may add to a file. */
export interface LinesMessage {
  readonly type: "lines";
  /** The lines. */
  readonly text: string;
  /** Constant. */
  readonly path: string;
}

/** All that a page is told at once; it shows nothing of it before it has taken all of it. */
export interface Change {
  readonly type: "change";
  /** Whether this is the whole state: what it does not mention is gone. */
  readonly is_whole: boolean;
  /** In the order in which they are to be taken. */
  readonly parts: readonly Part[];
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
  | LinesMessage;
