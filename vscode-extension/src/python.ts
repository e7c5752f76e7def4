// Which Python runs the server: candidates in order of preference, and what each of them can do.
import { execFile } from "node:child_process";
import * as path from "node:path";

export type Command = readonly [string, ...string[]];

export interface Interpreter {
  readonly command: Command;
  readonly version: readonly number[];
  /** Packages for mechanics that it has not. */
  readonly missing: readonly string[];
}

export interface Search {
  readonly found?: Interpreter;
  /** One line for each command that was tried in vain: the command and why not. */
  readonly rejected: readonly string[];
}

export interface Hints {
  readonly configured: readonly string[];
  /** The Python extension's choice. */
  readonly selected?: Command;
  /** A folder whose `.venv` may be used; absent in an untrusted workspace. */
  readonly trustedFolder?: string;
  readonly platform: NodeJS.Platform;
}

export type Probe = (command: Command) => Promise<Interpreter>;

export const OLDEST_PYTHON = [3, 11] as const;
export const PROBE_MILLISECONDS = 20_000;
/** How long they may take where the user has named none of them. */
const PATIENCE_MILLISECONDS = 2_000;

/** The commands to try; a configured one is the only one. */
export function candidates(hints: Hints): Command[] {
  const [configured, ...options] = hints.configured;
  if (configured !== undefined && configured !== "") return [[configured, ...options]];
  const isWindows = hints.platform === "win32";
  const found: Command[] = hints.selected === undefined ? [] : [hints.selected];
  if (hints.trustedFolder !== undefined) {
    found.push([path.join(hints.trustedFolder, ".venv", isWindows ? "Scripts/python.exe" : "bin/python")]);
  }
  return isWindows ? [...found, ["py", "-3"], ["python"]] : [...found, ["python3"], ["python"]];
}

/**
 * Return the first candidate that has NumPy, else the first that can run the server at all.
 *
 * All are asked at once; one that does not answer delays what comes next for the time of `patience` at most.
 */
export async function search(
  commands: readonly Command[],
  probe: Probe,
  patience = PATIENCE_MILLISECONDS,
): Promise<Search> {
  const rejected: string[] = [];
  let usable: Interpreter | undefined;
  const late = lateness(patience);
  const answers = commands.map((command) => Promise.race([probe(command), late]));
  for (const answer of answers) answer.catch(() => undefined);
  for (const [index, command] of commands.entries()) {
    try {
      const interpreter = await answers[index]!;
      if (!isRecent(interpreter.version)) {
        rejected.push(`${command.join(" ")}: Python ${interpreter.version.join(".")} is too old`);
      } else if (interpreter.missing.includes("numpy")) {
        usable ??= interpreter;
      } else {
        return { found: interpreter, rejected };
      }
    } catch (error) {
      rejected.push(`${command.join(" ")}: ${(error as Error).message}`);
    }
  }
  return usable === undefined ? { rejected } : { found: usable, rejected };
}

/** What fails after a while. */
function lateness(milliseconds: number): Promise<never> {
  return new Promise((_, reject) => {
    setTimeout(() => reject(new Error("does not answer")), milliseconds);
  });
}

/** Run the probe script in the interpreter. Throws an error with a message for the user. */
export function probeWith(script: string): Probe {
  return (command) =>
    new Promise((resolve, reject) => {
      const [program, ...options] = command;
      execFile(program, [...options, script], { timeout: PROBE_MILLISECONDS }, (error, stdout, stderr) => {
        if (error) reject(new Error(reason(error, stderr)));
        else resolveAnswer(command, stdout, resolve, reject);
      });
    });
}

function resolveAnswer(
  command: Command,
  stdout: string,
  resolve: (interpreter: Interpreter) => void,
  reject: (error: Error) => void,
): void {
  try {
    const { version, missing } = JSON.parse(stdout) as Omit<Interpreter, "command">;
    resolve({ command, version, missing });
  } catch {
    reject(new Error("is no Python"));
  }
}

function reason(error: Error & { code?: unknown; killed?: boolean }, stderr: string): string {
  if (error.code === "ENOENT") return "not found";
  if (error.code === "EACCES") return "cannot be executed";
  if (error.killed === true) return "does not answer";
  return stderr.trim().split("\n").at(-1) || error.message;
}

/** Whether a version of Python can run the server. */
export function isRecent(version: readonly number[]): boolean {
  const [major = 0, minor = 0] = version;
  return major > OLDEST_PYTHON[0] || (major === OLDEST_PYTHON[0] && minor >= OLDEST_PYTHON[1]);
}
