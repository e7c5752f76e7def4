// The linter in the built-in Python: reads what it is pointed at, and writes that only.
import * as fs from "node:fs";
import * as path from "node:path";
import type { Pyodide } from "./pyodide";
import { ReadOnlyFiles, virtual } from "./readOnlyFiles";

const RUN = "from kindsl.frontends.cli.guest import run; run";

interface Bytes {
  toJs(): Uint8Array;
}

type Run = (
  args: unknown,
  folder: string,
  write: (place: string, content: Bytes) => string,
  sleep: (seconds: number) => void,
) => number;

/** Run the linter with its arguments in the working directory; return its exit status. */
export function lint(py: Pyodide, args: readonly string[]): number {
  const named = namedPaths(args), files = new ReadOnlyFiles(py), folder = process.cwd();
  files.addFolder(virtual(folder));
  for (const place of named.filter((one) => fs.existsSync(one))) {
    if (fs.statSync(place).isDirectory()) files.addFolder(virtual(place));
    else files.addDocument(virtual(place));
  }
  for (const [set, descriptor] of [["setStdout", 1], ["setStderr", 2]] as const) {
    const isatty = [process.stdout, process.stderr][descriptor - 1]?.isTTY ?? false;
    py[set]({ write: (data) => fs.writeSync(descriptor, data), isatty });
  }
  const given = args.map((arg) => (path.isAbsolute(arg) ? virtual(arg) : arg));
  const run = py.runPython(RUN) as Run;
  return run(py.toPy(given), virtual(folder), (place, content) => write(onDiskOf(place), content.toJs(), named), sleep);
}

/** What the arguments may name: paths, also behind an option's equals sign; without any, the working directory. */
function namedPaths(args: readonly string[]): string[] {
  const words = args.map((arg) => (arg.startsWith("-") ? arg.split("=").slice(1).join("=") : arg)).filter(Boolean);
  const places = words.map((word) => path.resolve(word));
  return places.some((place) => fs.existsSync(place)) ? places : [...places, process.cwd()];
}

/** Write a file that was named, or is in a folder that was; return the name of the error if that fails. */
function write(place: string, content: Uint8Array, named: readonly string[]): string {
  const isNamed = named.some((one) => place === one || place.startsWith(one + path.sep));
  if (!isNamed) return "EROFS";
  try {
    replace(fs.existsSync(place) ? fs.realpathSync(place) : place, content);
    return "";
  } catch (error) {
    return (error as NodeJS.ErrnoException).code ?? "EIO";
  }
}

/** Give a file its content by a neighbour that takes its place, wholly or not at all. */
function replace(target: string, content: Uint8Array): void {
  const mode = fs.existsSync(target) ? fs.statSync(target).mode : undefined;
  if (mode !== undefined) fs.accessSync(target, fs.constants.W_OK);
  const neighbour = path.join(path.dirname(target), `.kindsl-${process.pid}-${Date.now()}`);
  try {
    fs.writeFileSync(neighbour, content, { flag: "wx", flush: true });
    if (mode !== undefined) fs.chmodSync(neighbour, mode);
    fs.renameSync(neighbour, target);
  } catch (error) {
    fs.rmSync(neighbour, { force: true });
    throw error;
  }
}

/** Wait without using the processor, as Python's own sleep would here. */
function sleep(seconds: number): void {
  Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 1000 * seconds);
}

function onDiskOf(place: string): string {
  return process.platform === "win32" ? path.normalize(place.slice(1)) : place;
}
