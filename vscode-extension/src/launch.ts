// What is run to get a language server, or why nothing can be.
import { readdir } from "node:fs/promises";
import { homedir } from "node:os";
import * as vscode from "vscode";
import { BUILT_IN } from "./builtIn";
import type { Home } from "./home";
import { installedPythons } from "./installedPythons";
import { selectedInterpreter } from "./msPython";
import { candidates, PROBE_MILLISECONDS, probeWith, search, type Command, type Hints, type Interpreter, type Probe } from "./python";
import { readSettings, workspaceFolder, type Settings } from "./settings";

export interface Launch {
  readonly command: string;
  readonly args: readonly string[];
  readonly cwd: string | undefined;
  /** Absent where the user's own `kindsl.path` is run. */
  readonly interpreter?: Interpreter;
}

/** The built-in Python is to run the server. */
export interface BuiltIn {
  readonly isBuiltIn: true;
  /** Why none of the machine does. */
  readonly rejected: readonly string[];
}

/** What the setting for the interpreter names cannot run the server. */
export interface NoPython {
  readonly rejected: readonly string[];
}

export async function findLaunch(home: Home, log: vscode.LogOutputChannel): Promise<Launch | BuiltIn | NoPython> {
  const settings = readSettings();
  const [program, ...options] = settings.path;
  if (program !== undefined) {
    return { command: program, args: [...options, ...settings.args], cwd: workspaceFolder() };
  }
  if (settings.interpreter.length === 1 && settings.interpreter[0] === BUILT_IN) return { isBuiltIn: true, rejected: [] };
  const isNamed = settings.interpreter.length > 0;
  const patience = isNamed ? [PROBE_MILLISECONDS] : [];
  let result = await search(await allCandidates(settings, log), probeIn(home), ...patience);
  if (result.found === undefined && !isNamed) {
    const more = await search(await installed(), probeIn(home));
    result = { ...more, rejected: [...result.rejected, ...more.rejected.filter((line) => !line.endsWith(": not found"))] };
  }
  for (const line of result.rejected) log.warn(`Not used: ${line}`);
  if (result.found === undefined) {
    return isNamed ? { rejected: result.rejected } : { isBuiltIn: true, rejected: result.rejected };
  }
  log.info(`Using ${result.found.command.join(" ")}, Python ${result.found.version.join(".")}`);
  return launchWith(result.found, home, settings.importStrategy, ["language-server", ...settings.args]);
}

/** The command that runs a subcommand of kindsl in an interpreter. */
export function launchWith(
  interpreter: Interpreter,
  home: Home,
  importStrategy: Settings["importStrategy"],
  args: readonly string[],
): Launch {
  const [program, ...options] = interpreter.command;
  return {
    command: program,
    args: [...options, script(home, "launch.py"), importStrategy, ...args],
    cwd: workspaceFolder(),
    interpreter,
  };
}

/** The interpreters to choose from when the user has configured none. */
export async function detectedCandidates(log: vscode.LogOutputChannel): Promise<Command[]> {
  const first = candidates(await hints([], log));
  const known = new Set(first.map((command) => command.join(" ")));
  return [...first, ...(await installed()).filter((command) => !known.has(command.join(" ")))];
}

function installed(): Promise<Command[]> {
  const list = (folder: string): Promise<string[]> => readdir(folder).catch(() => []);
  return installedPythons({ home: homedir(), env: process.env, list }, process.platform);
}

async function allCandidates(settings: Settings, log: vscode.LogOutputChannel): Promise<Command[]> {
  return candidates(await hints(settings.interpreter, log));
}

async function hints(configured: readonly string[], log: vscode.LogOutputChannel): Promise<Hints> {
  const selected = configured.length > 0 ? undefined : await selectedInterpreter(log);
  const folder = vscode.workspace.isTrusted ? workspaceFolder() : undefined;
  return {
    configured,
    platform: process.platform,
    ...(selected === undefined ? {} : { selected }),
    ...(folder === undefined ? {} : { trustedFolder: folder }),
  };
}

/** What asks an interpreter what it has. */
export function probeIn(home: Home): Probe {
  return probeWith(script(home, "probe.py"));
}

function script(home: Home, name: string): string {
  return vscode.Uri.joinPath(home.extensionUri, "python", name).fsPath;
}
