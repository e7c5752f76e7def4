// The command "Select Python Interpreter".
import * as vscode from "vscode";
import { detectedCandidates, probeIn, type Home } from "./launch";
import { isPythonExtensionPresent } from "./msPython";
import type { Command } from "./python";

interface Choice extends vscode.QuickPickItem {
  readonly run: () => unknown;
}

export async function selectInterpreter(home: Home, log: vscode.LogOutputChannel): Promise<void> {
  const probe = probeIn(home);
  const choices: Choice[] = [];
  for (const command of await detectedCandidates(log)) {
    const interpreter = await probe(command).catch(() => undefined);
    if (interpreter === undefined) continue;
    const numbers = interpreter.missing.length > 0 ? "without NumPy" : "with NumPy";
    const description = `Python ${interpreter.version.join(".")}, ${numbers}`;
    choices.push({ label: command.join(" "), description, run: () => store(command) });
  }
  choices.push({ label: "$(edit) Enter a path...", run: enterPath });
  if (isPythonExtensionPresent()) {
    choices.push({ label: "$(list-selection) Choose in the Python extension...", run: chooseInPythonExtension });
  }
  const chosen = await vscode.window.showQuickPick(choices, { placeHolder: "Python that runs the Kinematics-DSL server" });
  await chosen?.run();
}

async function enterPath(): Promise<void> {
  const path = await vscode.window.showInputBox({ prompt: "Path of a Python interpreter", placeHolder: "~/venv/bin/python" });
  if (path !== undefined && path.trim() !== "") await store([path.trim()]);
}

async function chooseInPythonExtension(): Promise<void> {
  await store(undefined);
  await vscode.commands.executeCommand("python.setInterpreter");
}

/** Keep the choice in the user's settings, or in the workspace's where it is overridden there. */
async function store(command: Command | undefined): Promise<void> {
  const configuration = vscode.workspace.getConfiguration("kindsl");
  const inWorkspace = configuration.inspect("interpreter")?.workspaceValue !== undefined;
  const target = inWorkspace ? vscode.ConfigurationTarget.Workspace : vscode.ConfigurationTarget.Global;
  await configuration.update("interpreter", command, target);
}
