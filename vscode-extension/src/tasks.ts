// Tasks that run kdsl-lint with the same interpreter and libraries as the server.
import * as vscode from "vscode";
import { builtInCommand } from "./builtIn";
import type { Home } from "./home";
import { launchWith } from "./launch";
import type { Server } from "./server";
import { readSettings } from "./settings";

export const TASK_TYPE = "kindsl";

interface LintDefinition extends vscode.TaskDefinition {
  readonly paths: readonly string[];
  readonly args?: readonly string[];
}

export function registerTasks(home: Home, server: Server): vscode.Disposable {
  return vscode.tasks.registerTaskProvider(TASK_TYPE, {
    provideTasks: async () => {
      const tasks = await Promise.all(
        (vscode.workspace.workspaceFolders ?? []).map((folder) =>
          lintTask({ type: TASK_TYPE, paths: ["."] }, folder, `kdsl-lint ${folder.name}`, home, server),
        ),
      );
      return tasks.filter((task) => task !== undefined);
    },
    resolveTask: (task) => {
      const scope = task.scope ?? vscode.TaskScope.Workspace;
      return lintTask(task.definition as LintDefinition, scope, task.name, home, server);
    },
  });
}

async function lintTask(
  definition: LintDefinition,
  scope: vscode.WorkspaceFolder | vscode.TaskScope,
  name: string,
  home: Home,
  server: Server,
): Promise<vscode.Task | undefined> {
  await server.client();
  const lint = ["lint", ...editorSettings(scope), ...(definition.args ?? []), ...definition.paths];
  const execution = lintExecution(lint, home, server);
  if (execution === undefined) return undefined;
  // No problem matcher: the server lists the findings of all files of the folder, with their fixes.
  const task = new vscode.Task(definition, scope, name, "kindsl", execution, []);
  task.group = vscode.TaskGroup.Test;
  return task;
}

/** The settings that decide what is reported, so that the task agrees with the server. */
function editorSettings(scope: vscode.WorkspaceFolder | vscode.TaskScope): string[] {
  const configuration = vscode.workspace.getConfiguration("kindsl", typeof scope === "object" ? scope.uri : undefined);
  const names = ["target", "ignore", "severity", "parameters"];
  const set = names.map((name) => [name, configuration.get<object>(name)] as const).filter(([, value]) => value && Object.keys(value).length > 0);
  return set.length > 0 ? ["--editor-settings", JSON.stringify(Object.fromEntries(set))] : [];
}

function lintExecution(lint: readonly string[], home: Home, server: Server): vscode.ProcessExecution | undefined {
  if (server.isBuiltIn) {
    const { program, args, env } = builtInCommand(home, ...lint);
    return new vscode.ProcessExecution(program, args, { env });
  }
  if (server.interpreter === undefined) return undefined;
  const { command, args } = launchWith(server.interpreter, home, readSettings().importStrategy, lint);
  return new vscode.ProcessExecution(command, [...args]);
}
