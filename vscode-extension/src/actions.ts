// What a message offers to do about what it tells.
import * as vscode from "vscode";

export interface Action {
  readonly title: string;
  readonly run: () => unknown;
}

export const SHOW_LOG = command("Show Log", "kindsl.showLog");
export const RESTART = command("Restart Server", "kindsl.restart");

export function command(title: string, name: string, ...args: unknown[]): Action {
  return { title, run: () => vscode.commands.executeCommand(name, ...args) };
}

/** Say what is wrong, and do what the user chooses. */
export async function showError(message: string, actions: readonly Action[]): Promise<void> {
  const chosen = await vscode.window.showErrorMessage(message, ...actions.map(({ title }) => title));
  await actions.find(({ title }) => title === chosen)?.run();
}
