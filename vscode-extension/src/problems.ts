// What the user must put right: one message, with the actions that do it.
import * as vscode from "vscode";
import type { Launch } from "./launch";
import { OLDEST_PYTHON, type Interpreter } from "./python";

export type Problem =
  | { readonly kind: "noPython"; readonly rejected: readonly string[] }
  | { readonly kind: "noNumpy"; readonly interpreter: Interpreter }
  | { readonly kind: "startFailed"; readonly launch: Launch }
  | { readonly kind: "crashed"; readonly times: number };

type Action = readonly [title: string, run: () => unknown];

const SILENCED = "kindsl.silencedInterpreters";

/** Tell the problem, and do what the user chooses. */
export async function report(problem: Problem, memory: vscode.Memento): Promise<void> {
  if (problem.kind === "noNumpy" && isSilenced(problem.interpreter, memory)) return;
  const actions = actionsFor(problem, memory);
  const titles = actions.map(([title]) => title);
  const show = problem.kind === "noNumpy" ? vscode.window.showWarningMessage : vscode.window.showErrorMessage;
  const chosen = await show(describe(problem), ...titles);
  await actions.find(([title]) => title === chosen)?.[1]();
}

export function describe(problem: Problem): string {
  switch (problem.kind) {
    case "noPython":
      return `Kinematics-DSL needs Python ${OLDEST_PYTHON.join(".")} or later: ${problem.rejected.join("; ")}`;
    case "noNumpy":
      return `NumPy is not installed in ${problem.interpreter.command.join(" ")}: checks and completion work, the preview and computed numbers do not`;
    case "startFailed":
      return `The Kinematics-DSL server could not be started with ${problem.launch.command}`;
    case "crashed":
      return `The Kinematics-DSL server ended ${problem.times} times in a short while and is not started again`;
  }
}

/** Install what the preview needs, in a terminal where the user sees it happen. */
export function installPackages(interpreter: Interpreter): void {
  const [program, ...options] = interpreter.command;
  const terminal = vscode.window.createTerminal({
    name: "Install for Kinematics-DSL",
    shellPath: program,
    shellArgs: [...options, "-m", "pip", "install", ...interpreter.missing],
  });
  terminal.show();
  const closing = vscode.window.onDidCloseTerminal((closed) => {
    if (closed !== terminal) return;
    closing.dispose();
    void vscode.commands.executeCommand("kindsl.restart");
  });
}

function actionsFor(problem: Problem, memory: vscode.Memento): Action[] {
  const select = command("Select Interpreter", "kindsl.selectInterpreter");
  const log = command("Show Log", "kindsl.showLog");
  const restart = command("Restart Server", "kindsl.restart");
  switch (problem.kind) {
    case "noPython":
      return [select, ["Get Python", () => vscode.env.openExternal(vscode.Uri.parse("https://www.python.org/downloads/"))], log];
    case "noNumpy":
      return [
        ["Install", () => installPackages(problem.interpreter)],
        select,
        ["Don't Show Again", () => silence(problem.interpreter, memory)],
      ];
    case "startFailed":
      return usesEnvironment() ? [["Use Bundled Libraries", useBundled], log] : [restart, log];
    case "crashed":
      return [restart, log];
  }
}

function command(title: string, name: string): Action {
  return [title, () => vscode.commands.executeCommand(name)];
}

function usesEnvironment(): boolean {
  return vscode.workspace.getConfiguration("kindsl").get("importStrategy") === "fromEnvironment";
}

function useBundled(): Thenable<void> {
  const configuration = vscode.workspace.getConfiguration("kindsl");
  const inWorkspace = configuration.inspect("importStrategy")?.workspaceValue !== undefined;
  const target = inWorkspace ? vscode.ConfigurationTarget.Workspace : vscode.ConfigurationTarget.Global;
  return configuration.update("importStrategy", "useBundled", target);
}

function isSilenced(interpreter: Interpreter, memory: vscode.Memento): boolean {
  return memory.get<string[]>(SILENCED, []).includes(interpreter.command.join(" "));
}

function silence(interpreter: Interpreter, memory: vscode.Memento): Thenable<void> {
  return memory.update(SILENCED, [...memory.get<string[]>(SILENCED, []), interpreter.command.join(" ")]);
}
