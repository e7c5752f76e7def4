// Plays a motion from a file: the robot follows, and a plot tells what its joints must do for it.
import { byId, format, make, partOf } from "../base/elements.js";
import { inverseDynamics } from "../picture/dynamics.js";
import { poseAt, rates, readTrajectory } from "../picture/trajectory.js";

/** @import { Scene } from "../picture/scene.js" */
/** @import { Trajectory } from "../picture/trajectory.js" */
/** @typedef {{ setCursor(at: object): void, setSize(size: object): void, destroy(): void, valToPos(value: number, scale: string): number }} Plot */

const MOST_POINTS = 1000; // of a curve
const HEIGHT = 150; // pixels
const REST = 500; // milliseconds
const LINES = ["#1f5fc9", "#b9590f", "#0f7566", "#a3347f", "#866100", "#6b4fae", "#1e7d3c", "#b42a1d"];

export class Player {
  /** @type {Trajectory | null} */
  trajectory = null;
  time = 0;
  isPlaying = false;
  /** @type {Plot | null} */
  #plot = null;
  #before = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {Scene} scene @param {HTMLElement} pane @param {(names: readonly string[]) => void} onStop */
  constructor(scene, pane, onStop) {
    this.scene = scene;
    this.onStop = onStop;
    this.section = byId("player");
    this.title = partOf(this.section, ".file");
    /** @type {HTMLButtonElement} */
    this.play = partOf(this.section, ".start");
    /** @type {HTMLInputElement} */
    this.slider = partOf(this.section, "input[type=range]");
    /** @type {HTMLInputElement} */
    this.loops = partOf(this.section, "input[type=checkbox]");
    this.told = partOf(this.section, "output");
    this.chart = partOf(this.section, ".chart");
    this.play.addEventListener("click", () => this.toggle());
    this.slider.addEventListener("input", () => this.seek(Number(this.slider.value)));
    /** @type {HTMLInputElement} */
    const file = byId("motion-file");
    byId("play-file").addEventListener("click", () => file.click());
    file.addEventListener("change", () => this.open(file.files?.[0]));
    pane.addEventListener("dragover", (event) => event.preventDefault());
    pane.addEventListener("drop", (event) => this.drop(event));
  }

  /** @param {DragEvent} event */
  drop(event) {
    event.preventDefault();
    this.open(event.dataTransfer?.files[0]);
  }

  /** @param {File | undefined} file */
  async open(file) {
    if (file) this.load(file.name, await file.text());
  }

  /** @param {string} name @param {string} text */
  load(name, text) {
    this.stop();
    const found = readTrajectory(text, new Set(this.scene.trees.robot.joints.keys())), isWrong = typeof found === "string";
    this.section.hidden = false;
    this.trajectory = isWrong ? null : found;
    for (const part of partOf(this.section, ".controls").children) /** @type {HTMLElement} */ (part).hidden = isWrong;
    this.#plot?.destroy();
    this.#plot = null;
    if (isWrong) {
      this.title.textContent = `${name}: ${found}`;
      return;
    }
    const { times, tracks, strange } = found, left = strange.length ? `, without ${strange.map((one) => `'${one}'`).join(", ")}` : "";
    this.title.textContent = `${name}: ${times.length} samples, ${tracks.length} joint${tracks.length === 1 ? "" : "s"}${left}`;
    Object.assign(this.slider, { min: String(times[0]), max: String(times.at(-1)), step: "any" });
    this.draw(found);
    this.seek(times[0]);
  }

  toggle() {
    if (this.isPlaying) return this.stop();
    if (!this.trajectory) return;
    const { times } = this.trajectory, end = times[times.length - 1];
    if (this.time >= end) this.time = times[0];
    this.isPlaying = true;
    this.play.textContent = "❚❚";
    this.play.ariaLabel = "Pause";
    this.#before = performance.now();
    requestAnimationFrame((now) => this.step(now));
  }

  /** @param {number} now */
  step(now) {
    if (!this.isPlaying || !this.trajectory) return;
    const { times } = this.trajectory, begin = times[0], end = times[times.length - 1];
    let time = this.time + Math.max(0, now - this.#before) / 1000;
    this.#before = now;
    if (time > end && this.loops.checked) time = begin + ((time - begin) % (end - begin));
    this.seek(Math.min(time, end));
    if (time >= end) this.stop();
    else requestAnimationFrame((later) => this.step(later));
  }

  stop() {
    if (!this.isPlaying) return;
    this.isPlaying = false;
    this.play.textContent = "▶";
    this.play.ariaLabel = "Play";
    this.onStop((this.trajectory?.tracks ?? []).map(({ name }) => name));
  }

  // The robot is another: the same motion takes other torques, told once it has stayed so for a while.
  renew() {
    clearTimeout(this.#timer);
    if (!this.trajectory) return;
    this.chart.classList.add("stale");
    this.#timer = setTimeout(() => {
      if (this.trajectory) this.draw(this.trajectory);
      this.mark();
    }, REST);
  }

  /** @param {number} time Seconds. */
  seek(time) {
    if (!this.trajectory) return;
    this.time = time;
    for (const [name, value] of poseAt(this.trajectory, time)) this.scene.q.set(name, value);
    this.slider.value = String(time);
    this.told.textContent = `${format(time, 2)} s`;
    this.mark();
    this.scene.changed("motion");
  }

  // Show the present time in the plot.
  mark() { this.#plot?.setCursor({ left: this.#plot.valToPos(this.time, "x"), top: 0 }); }

  /**
   * The torques of inverse dynamics over time, of so many samples as can be told apart.
   * @param {Trajectory} trajectory
   */
  draw({ times, tracks }) {
    const names = tracks.map(({ name }) => name), curves = torques(this.scene, { times, tracks, strange: [] });
    const style = getComputedStyle(document.documentElement), ink = style.getPropertyValue("--faint").trim(), line = style.getPropertyValue("--line").trim();
    const axis = { stroke: ink, grid: { stroke: line, width: 1 }, ticks: { stroke: line, width: 1 }, size: 38 };
    const series = names.map((label, i) => ({ label, stroke: LINES[i % LINES.length], width: 1 }));
    const options = {
      width: Math.max(120, this.chart.clientWidth), height: HEIGHT, legend: { show: false }, scales: { x: { time: false } },
      axes: [{ ...axis, size: 28 }, axis], series: [{}, ...series], cursor: { y: false, drag: { x: false, y: false } },
    };
    this.#plot?.destroy();
    this.chart.classList.remove("stale");
    this.#plot = new uPlot(options, [curves.times, ...curves.values], this.chart);
    const legend = names.map((name, i) => {
      const entry = make("span", "", name);
      entry.style.borderColor = LINES[i % LINES.length];
      return entry;
    });
    partOf(this.section, ".names").replaceChildren(...legend);
  }
}

/**
 * What joints must do for a motion: torques in N m, forces in N.
 * @param {Pick<Scene, "trees">} scene
 * @param {Trajectory} trajectory
 */
export function torques({ trees: { robot } }, { times, tracks }) {
  const speeds = tracks.map(({ values }) => rates(times, values)), gains = speeds.map((values) => rates(times, values));
  const step = Math.max(1, Math.ceil(times.length / MOST_POINTS)), chosen = times.map((_, i) => i).filter((i) => i % step === 0);
  const rows = chosen.map((i) => {
    const at = (/** @type {readonly (readonly number[])[]} */ lists) => new Map(tracks.map(({ name }, k) => [name, lists[k][i]]));
    return inverseDynamics(robot, at(tracks.map(({ values }) => values)), at(speeds), at(gains));
  });
  return { times: chosen.map((i) => times[i]), values: tracks.map(({ name }) => rows.map((row) => row.get(name) ?? 0)) };
}
