// What the life of a language server is wherever it runs: steps in order, and a state that others may follow.
import * as vscode from "vscode";
import type { BaseLanguageClient } from "vscode-languageclient";
import { STATE_CONTEXT, type ServerAccess, type ServerState } from "./serverAccess";

export abstract class ServerLife<Client extends BaseLanguageClient> implements ServerAccess, vscode.Disposable {
  readonly #changed = new vscode.EventEmitter<ServerState>();
  readonly onDidChange = this.#changed.event;

  /** The client of the server that runs or starts. */
  protected current: Client | undefined;
  #state: ServerState = "stopped";
  #isWanted = false;
  #queue: Promise<void> = Promise.resolve();

  get state(): ServerState {
    return this.#state;
  }

  /** Whether a server was ever asked for: until then none is started again either. */
  get isWanted(): boolean {
    return this.#isWanted;
  }

  async client(): Promise<Client | undefined> {
    await this.start();
    return this.#state === "running" ? this.current : undefined;
  }

  settled(): Promise<void> {
    return this.#queue;
  }

  /** Start a server unless one was asked for before. */
  start(): Promise<void> {
    return this.#isWanted ? this.#queue : this.restart();
  }

  restart(): Promise<void> {
    this.#isWanted = true;
    return this.#enqueue(async () => {
      await this.end();
      await this.begin();
    });
  }

  stop(): Promise<void> {
    return this.#enqueue(() => this.end());
  }

  dispose(): void {
    this.#changed.dispose();
  }

  /** Start a server; none runs. */
  protected abstract begin(): Promise<void>;

  /** End the server, if one runs. */
  protected abstract end(): Promise<void>;

  /** Tell of a step that did not end as it should. */
  protected abstract stepFailed(error: unknown): void;

  protected set(state: ServerState): void {
    if (state === this.#state) return;
    this.#state = state;
    void vscode.commands.executeCommand("setContext", STATE_CONTEXT, state);
    this.#changed.fire(state);
  }

  #enqueue(step: () => Promise<void>): Promise<void> {
    this.#queue = this.#queue.then(step).catch((error) => this.stepFailed(error));
    return this.#queue;
  }
}
