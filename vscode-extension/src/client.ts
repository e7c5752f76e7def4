// The language client of a server in a process of its own.
import type { ChildProcess } from "node:child_process";
import type * as vscode from "vscode";
import { LanguageClient, type ServerOptions } from "vscode-languageclient/node";
import type { LanguageClientOptions } from "vscode-languageclient";
import { clientOptions, LANGUAGE, OTHER_ROBOTS, TRANSFORMS, type ClientHooks, type DocumentStatus } from "./clientOptions";
import type { Launch } from "./launch";

/** A client that logs its errors only: what the user must know is said once, by problems.ts. */
class QuietClient extends LanguageClient {
  override error(message: string, data?: unknown): void {
    super.error(message, data, false);
  }

  /** Stop what runs; the library itself throws at a server that ended while it was starting. */
  override async stop(timeout?: number): Promise<void> {
    if (this.isRunning()) await super.stop(timeout);
  }
}

/** A client of what a command runs, or of a server that a function starts. */
export function createClient(
  launch: Launch | (() => ChildProcess),
  log: vscode.LogOutputChannel,
  hooks: ClientHooks,
): LanguageClient {
  const server = typeof launch === "function" ? () => Promise.resolve(launch()) : executable(launch);
  const client = new QuietClient("kindsl", "Kinematics-DSL", server, options(log, hooks));
  client.onNotification("kindsl/status", (status: DocumentStatus) => hooks.showStatus(status));
  return client;
}

function executable({ command, args, cwd }: Launch): ServerOptions {
  return { command, args: [...args], options: cwd === undefined ? {} : { cwd } };
}

function options(log: vscode.LogOutputChannel, hooks: ClientHooks): LanguageClientOptions {
  const documentSelector = [
    { scheme: "file", language: LANGUAGE },
    { scheme: "untitled", language: LANGUAGE },
    { scheme: "file", language: TRANSFORMS },
    { scheme: "untitled", language: TRANSFORMS },
    { scheme: "file", pattern: OTHER_ROBOTS },
    // What is wrong in the configuration, and links to the robots that it names.
    { scheme: "file", pattern: "**/kindsl.toml" },
  ];
  return { ...clientOptions(log, hooks), documentSelector };
}
