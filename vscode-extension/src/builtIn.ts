// The Python that the extension brings along, in a process of the editor's own Node.
import { spawn, type ChildProcess } from "node:child_process";
import * as vscode from "vscode";
import type { Home } from "./home";

/** How the setting for the interpreter names it. */
export const BUILT_IN = "built-in";
/** What Python could make of JavaScript's eval would reach the disk. */
const FLAGS = ["--disallow-code-generation-from-strings"];
const ENVIRONMENT = { ELECTRON_RUN_AS_NODE: "1", NODE_OPTIONS: "" };
const START_MILLISECONDS = 30_000;

/** A program with its arguments and what it needs in its environment. */
export interface NodeCommand {
  readonly program: string;
  readonly args: string[];
  readonly env: Record<string, string>;
}

/** What runs the language server, or with arguments a command, in the built-in Python. */
export function builtInCommand(home: Home, ...args: readonly string[]): NodeCommand {
  const script = vscode.Uri.joinPath(home.extensionUri, "server", "host.js").fsPath;
  return { program: process.execPath, args: [...FLAGS, script, ...args], env: ENVIRONMENT };
}

/** The process of a language server; a busy one does not hear that it should end, and is killed. */
export class BuiltInProcess {
  #child: ChildProcess | undefined;

  constructor(
    private readonly home: Home,
    private readonly log: vscode.LogOutputChannel,
  ) {}

  /** Start it, instead of one that ran before. */
  start(): ChildProcess {
    this.kill();
    const { program, args, env } = builtInCommand(this.home);
    const child = (this.#child = spawn(program, args, { env: { ...process.env, ...env } }));
    child.on("error", (error) => this.log.error(`The built-in Python does not start: ${error.message}`));
    const impatience = setTimeout(() => child.kill("SIGKILL"), START_MILLISECONDS);
    child.stdout.once("data", () => clearTimeout(impatience));
    child.once("exit", () => clearTimeout(impatience));
    return child;
  }

  kill(): void {
    this.#child?.kill("SIGKILL");
    this.#child = undefined;
  }
}
