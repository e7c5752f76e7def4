// What the user must put right: one message, with the actions that do it.
import * as vscode from "vscode";
import { command, RESTART, SHOW_LOG, showError, type Action } from "./actions";
import type { Launch } from "./launch";
import { OLDEST_PYTHON } from "./python";

export type Problem =
  | { readonly kind: "noPython"; readonly rejected: readonly string[] }
  | { readonly kind: "noInterpreter"; readonly rejected: readonly string[] }
  | { readonly kind: "startFailed"; readonly launch: Launch }
  | { readonly kind: "crashed"; readonly times: number };

const SELECT = command("Select Interpreter", "kindsl.selectInterpreter");
const DOWNLOADS = "https://www.python.org/downloads/";

/** Tell the problem, and do what the user chooses. */
export async function report(problem: Problem): Promise<void> {
  await showError(describe(problem), actionsFor(problem));
}

export function describe(problem: Problem): string {
  switch (problem.kind) {
    case "noPython":
      return `Kinematics-DSL needs Python ${OLDEST_PYTHON.join(".")} or later: ${problem.rejected.join("; ")}`;
    case "noInterpreter":
      return `The setting kindsl.interpreter names no Python ${OLDEST_PYTHON.join(".")} or later: ${problem.rejected.join("; ")}`;
    case "startFailed":
      if (problem.launch.interpreter === undefined) return `The setting kindsl.path names no language server that starts: ${problem.launch.command}`;
      return `The Kinematics-DSL server could not be started with ${problem.launch.command}`;
    case "crashed":
      return `The Kinematics-DSL server ended ${problem.times} times in a short while and is not started again`;
  }
}

export function actionsFor(problem: Problem): Action[] {
  switch (problem.kind) {
    case "noPython": {
      const download = () => vscode.env.openExternal(vscode.Uri.parse(DOWNLOADS));
      return [SELECT, { title: "Get Python", run: download }, SHOW_LOG];
    }
    case "noInterpreter":
      return [openSettings("kindsl.interpreter"), SELECT, SHOW_LOG];
    case "startFailed":
      if (problem.launch.interpreter === undefined) return [openSettings("kindsl.path"), SHOW_LOG];
      return usesEnvironment() ? [{ title: "Use Bundled Libraries", run: useBundled }, SHOW_LOG] : [RESTART, SHOW_LOG];
    case "crashed":
      return [RESTART, SHOW_LOG];
  }
}

function openSettings(name: string): Action {
  return command("Open Settings", "workbench.action.openSettings", name);
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
