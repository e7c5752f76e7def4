// Packages that mechanics need: installed on request, into a folder of the extension's own.
import { spawn } from "node:child_process";
import * as vscode from "vscode";
import { command, showError, SHOW_LOG } from "./actions";
import { script, type Home } from "./launch";
import type { Interpreter } from "./python";
import type { Server } from "./server";

const NO_PIP = 3;
const UNREACHABLE = /NewConnectionError|NameResolutionError|getaddrinfo|ConnectTimeout|ProxyError|Network is unreachable/;
const NOT_OFFERED = /No matching distribution|Could not find a version/;

/** Install packages for the interpreter that runs the server, and start that again. */
export async function installPackages(names: readonly string[], home: Home, server: Server, log: vscode.LogOutputChannel) {
  const { interpreter } = server;
  if (interpreter === undefined) {
    await showError("Packages can be installed only for a Python that the extension has chosen", [SHOW_LOG]);
    return;
  }
  const target = vscode.Uri.file(interpreter.packages);
  const part = vscode.Uri.file(`${interpreter.packages}.part`);
  const options = { location: vscode.ProgressLocation.Notification, title: `Installing ${names.join(", ")}`, cancellable: true };
  await remove(part);
  const problem = await vscode.window.withProgress(options, (progress, token) =>
    run(interpreter, [script(home, "install.py"), part.fsPath, ...names], progress, token, log),
  );
  if (problem === undefined) {
    await server.restart(async () => vscode.workspace.fs.rename(part, target, { overwrite: true }));
    return;
  }
  await remove(part);
  if (problem !== "cancelled") await showError(problem, [command("Try Again", "kindsl.installPackages", names), SHOW_LOG]);
}

/** Run pip to its end; return what the user should read if it did not install. */
function run(
  interpreter: Interpreter,
  args: readonly string[],
  progress: vscode.Progress<{ message: string }>,
  token: vscode.CancellationToken,
  log: vscode.LogOutputChannel,
): Promise<string | undefined> {
  const [program, ...options] = interpreter.command;
  const process = spawn(program, [...options, ...args], { stdio: ["ignore", "pipe", "pipe"] });
  token.onCancellationRequested(() => process.kill());
  let said = "";
  const listen = (chunk: Buffer) => {
    said += chunk.toString();
    for (const line of chunk.toString().split(/\r?\n/).filter(Boolean)) {
      log.info(line);
      progress.report({ message: line.trim().slice(0, 80) });
    }
  };
  process.stdout.on("data", listen);
  process.stderr.on("data", listen);
  return new Promise((resolve) => {
    process.on("error", (error) => resolve(`The installation did not start: ${error.message}`));
    process.on("close", (code) => {
      if (token.isCancellationRequested) resolve("cancelled");
      else resolve(code === 0 ? undefined : reason(code, said, interpreter));
    });
  });
}

function reason(code: number | null, said: string, { command: [program], version }: Interpreter): string {
  if (code === NO_PIP) return `${program} has no pip to install with; choose another interpreter, or install pip in it`;
  if (UNREACHABLE.test(said)) return "Nothing was installed: the package index cannot be reached; is there a network?";
  if (NOT_OFFERED.test(said)) return `Nothing was installed: the package index offers nothing for Python ${version.join(".")}`;
  return "Nothing was installed: pip failed; the log says why";
}

async function remove(folder: vscode.Uri): Promise<void> {
  await vscode.workspace.fs.delete(folder, { recursive: true }).then(undefined, () => undefined);
}
