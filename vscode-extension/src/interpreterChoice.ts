// The command "Select Python Interpreter".
import * as vscode from "vscode";
import { BUILT_IN } from "./builtIn";
import type { Home } from "./home";
import { detectedCandidates, probeIn } from "./launch";
import { isPythonExtensionPresent } from "./msPython";
import { isRecent, OLDEST_PYTHON, type Command, type Interpreter } from "./python";

interface Choice extends vscode.QuickPickItem {
  readonly run: () => unknown;
}

export async function selectInterpreter(home: Home, log: vscode.LogOutputChannel): Promise<void> {
  const probe = probeIn(home);
  const choices: Choice[] = [];
  const commands = await detectedCandidates(log);
  const found = await Promise.all(commands.map((command) => probe(command).catch(() => undefined)));
  for (const interpreter of found.filter((one) => one !== undefined)) choices.push(choiceOf(interpreter));
  choices.push({ label: "$(package) Built-in Python", description: "of this extension", run: () => store([BUILT_IN]) });
  choices.push({ label: "$(edit) Enter a path...", run: enterPath });
  if (isPythonExtensionPresent()) {
    choices.push({ label: "$(list-selection) Choose in the Python extension...", run: chooseInPythonExtension });
  }
  const chosen = await vscode.window.showQuickPick(choices, { placeHolder: "Python that runs the Kinematics-DSL server" });
  await chosen?.run();
}

/** One line of the list; a Python that is too old is shown, and cannot be taken. */
function choiceOf(interpreter: Interpreter): Choice {
  const { command, version, missing } = interpreter, label = command.join(" "), number = `Python ${version.join(".")}`;
  if (!isRecent(version)) {
    const wanted = `needs Python ${OLDEST_PYTHON.join(".")} or later`;
    const told = (): unknown => vscode.window.showWarningMessage(`${label} is ${number}: the server ${wanted}.`);
    return { label: `$(circle-slash) ${label}`, description: `${number}, too old`, run: told };
  }
  const description = `${number}, ${missing.length > 0 ? "without" : "with"} NumPy`;
  return { label, description, run: () => store(command) };
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
