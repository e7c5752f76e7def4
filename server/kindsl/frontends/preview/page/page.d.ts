// The parts of the page. `start.js` puts them together one after another: each is there before anything happens in the page.
import type { Address } from "./address.js";
import type { Selection } from "./base/selection.js";
import type { Actions, Request, Viewer } from "./base/types.js";
import type { Units } from "./base/units.js";
import type { Editing } from "./editing/editing.js";
import type { PullDrag } from "./editing/pull_drag.js";
import type { History } from "./history.js";
import type { Inbox } from "./inbox.js";
import type { MeshButton } from "./panel/mesh_button.js";
import type { Compare } from "./panel/compare.js";
import type { Findings } from "./panel/findings.js";
import type { JointRows } from "./panel/joint_rows.js";
import type { Keys } from "./panel/keys.js";
import type { Legend } from "./panel/legend.js";
import type { ParameterRows } from "./panel/parameter_rows.js";
import type { Player } from "./panel/player.js";
import type { Poses } from "./panel/poses.js";
import type { Splitter } from "./panel/splitter.js";
import type { Tree } from "./panel/tree.js";
import type { Away } from "./picture/away.js";
import type { Camera } from "./picture/camera.js";
import type { Compass } from "./picture/compass.js";
import type { Labels } from "./picture/labels.js";
import type { LineArt } from "./picture/line_art.js";
import type { Measure } from "./picture/measure.js";
import type { Motion } from "./picture/motion.js";
import type { Picking } from "./picture/picking.js";
import type { Presets } from "./picture/presets.js";
import type { ScaleBar } from "./picture/scale_bar.js";
import type { Scene } from "./picture/scene.js";
import type { Stage } from "./picture/stage.js";
import type { Theme } from "./theme.js";

/** The line to what shows the page. */
export interface Line {
  send(request: Request): void;
}
/** What a line is made with. */
export interface LineEvents {
  /** A message came, packed. */
  onFrame(frame: Uint8Array): void;
  /** A message came as it is. */
  onMessage(message: unknown): void;
  onState(state: "live" | "reconnecting"): void;
  /** What to say first. */
  greeting(): Request;
}

export interface Page {
  /** Whether it shows a state that is in it, without a server. */
  isStatic: boolean;
  pane: HTMLElement;
  viewer: Viewer;
  theme: Theme;
  scene: Scene;
  stage: Stage;
  camera: Camera;
  selection: Selection;
  presets: Presets;
  units: Units;
  inbox: Inbox;
  measure: Measure;
  actions: Actions;
  labels: Labels;
  picking: Picking;
  lineArt: LineArt;
  compass: Compass;
  scaleBar: ScaleBar;
  away: Away;
  joints: JointRows;
  parameters: ParameterRows;
  player: Player;
  poses: Poses;
  tree: Tree;
  findings: Findings;
  legend: Legend;
  meshes: MeshButton;
  compare: Compare;
  address: Address;
  bars: readonly Splitter[];
  editing: Editing;
  pull: PullDrag;
  history: History;
  keys: Keys;
  motion: Motion;
  connection: Line | null;
  send(request: Request): void;
}
