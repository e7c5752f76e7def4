// The Python extension, which need not be there: the environment that the user selected in it.
import * as vscode from "vscode";
import type { Command } from "./python";

interface PythonExtension {
  readonly environments: {
    getActiveEnvironmentPath(resource?: vscode.Uri): { readonly path: string };
    resolveEnvironment(
      environment: unknown,
    ): Promise<{ readonly executable: { readonly uri?: vscode.Uri } } | undefined>;
    readonly onDidChangeActiveEnvironmentPath: vscode.Event<unknown>;
  };
}

const EXTENSION = "ms-python.python";

export function isPythonExtensionPresent(): boolean {
  return vscode.extensions.getExtension(EXTENSION) !== undefined;
}

export async function selectedInterpreter(log: vscode.LogOutputChannel): Promise<Command | undefined> {
  try {
    const api = await pythonExtension();
    const folder = vscode.workspace.workspaceFolders?.[0]?.uri;
    const chosen = api?.environments.getActiveEnvironmentPath(folder);
    const environment = await api?.environments.resolveEnvironment(chosen);
    const executable = environment?.executable.uri?.fsPath;
    return executable === undefined ? undefined : [executable];
  } catch (error) {
    log.warn(`The Python extension does not tell its interpreter: ${String(error)}`);
    return undefined;
  }
}

/** Call `listener` when the user selects another environment. */
export async function onSelectionChange(listener: () => void): Promise<vscode.Disposable | undefined> {
  const api = await pythonExtension().catch(() => undefined);
  return api?.environments.onDidChangeActiveEnvironmentPath(listener);
}

async function pythonExtension(): Promise<PythonExtension | undefined> {
  return vscode.extensions.getExtension<PythonExtension>(EXTENSION)?.activate();
}
