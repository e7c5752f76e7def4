// The life of the language server: one at a time, started, stopped and started again in order.
import * as vscode from "vscode";
import { State as ClientState, type LanguageClient } from "vscode-languageclient/node";
import { BuiltInProcess } from "./builtIn";
import { createClient } from "./client";
import { rulePages, type Requests } from "./clientOptions";
import type { Home } from "./home";
import { findLaunch, type BuiltIn, type Launch } from "./launch";
import type { Interpreter } from "./python";
import type { Problem } from "./problems";
import { PAGE_MESSAGES, PAGE_REQUEST, type PageMessages, type PageServer } from "./serverAccess";
import { ServerLife } from "./serverLife";

/** A server that ends by itself more often than that within the window is left alone. */
const CRASHES = { limit: 4, windowMilliseconds: 180_000 };

export class Server extends ServerLife<LanguageClient> implements PageServer {
  readonly #failed = new vscode.EventEmitter<Problem>();
  /** Something that the user must put right. */
  readonly onProblem = this.#failed.event;
  readonly #drawn = new vscode.EventEmitter<PageMessages>();
  readonly onPageMessages = this.#drawn.event;

  #problem: Problem | undefined;
  #interpreter: Interpreter | undefined;
  readonly #builtIn: BuiltInProcess;
  #isBuiltIn = false;
  #crashes: number[] = [];

  constructor(
    private readonly home: Home,
    private readonly log: vscode.LogOutputChannel,
    private readonly requests: Requests,
  ) {
    super();
    this.#builtIn = new BuiltInProcess(home, log);
  }

  /** Why no server runs, where that is so. */
  get problem(): Problem | undefined {
    return this.state === "failed" ? this.#problem : undefined;
  }

  /** The interpreter that was found last, whether or not the server could run in it. */
  get interpreter(): Interpreter | undefined {
    return this.#interpreter;
  }

  get isBuiltIn(): boolean {
    return this.#isBuiltIn;
  }

  sendFromPage(document: string, request: unknown): void {
    if (this.state === "running") void this.current?.sendNotification(PAGE_REQUEST, { document, request });
  }

  override dispose(): void {
    super.dispose();
    this.#failed.dispose();
    this.#drawn.dispose();
  }

  protected override async begin(): Promise<void> {
    this.#crashes = [];
    this.set("starting");
    const launch = await findLaunch(this.home, this.log);
    this.#isBuiltIn = "isBuiltIn" in launch;
    this.#interpreter = "interpreter" in launch ? launch.interpreter : undefined;
    if ("isBuiltIn" in launch) await this.#runBuiltIn(launch);
    else if ("rejected" in launch) this.#fail({ kind: "noInterpreter", rejected: launch.rejected });
    else await this.#runCommand(launch);
  }

  async #runCommand(launch: Launch): Promise<void> {
    this.log.info(`Starting ${launch.command} ${launch.args.join(" ")}`);
    const client = createClient(launch, this.log, { ...this.requests, crashed: () => this.#crashed() });
    await this.#run(client, { kind: "startFailed", launch });
  }

  async #runBuiltIn({ rejected }: BuiltIn): Promise<void> {
    this.log.info("Starting the built-in Python");
    const hooks = { ...this.requests, crashed: () => this.#crashed(), rules: rulePages(this.home.extensionUri) };
    const client = createClient(() => this.#builtIn.start(), this.log, hooks);
    client.onNotification(PAGE_MESSAGES, (params: PageMessages) => this.#drawn.fire(params));
    await this.#run(client, { kind: "noPython", rejected: [...rejected, "the built-in Python does not start"] });
  }

  /** Start a client; one whose server ends meanwhile is a problem of the user's. */
  async #run(client: LanguageClient, problem: Problem): Promise<void> {
    this.current = client;
    client.onDidChangeState(({ newState }) => this.#follow(client, newState));
    // A server that ends while it is starting may leave the promise resolved: the client's state decides.
    await client.start().catch((error) => this.log.error(`The server did not start: ${String(error)}`));
    if (!client.isRunning()) this.#fail(problem);
  }

  protected override async end(): Promise<void> {
    const client = this.current;
    this.current = undefined;
    this.set("stopped");
    await client?.stop().catch((error) => this.log.warn(`The server did not stop in order: ${String(error)}`));
    this.#builtIn.kill();
  }

  /** Take over the client's own transitions: a restart after a crash does not pass through here. */
  #follow(client: LanguageClient, state: ClientState): void {
    if (client !== this.current) return;
    if (state === ClientState.Running) this.set("running");
    if (state === ClientState.Starting) this.set("starting");
  }

  #crashed(): boolean {
    // The first start reports its own failure; one that follows a crash is the library's.
    if (this.state !== "running" && this.#crashes.length === 0) return false;
    const now = Date.now();
    this.#crashes = [...this.#crashes.filter((time) => now - time < CRASHES.windowMilliseconds), now];
    if (this.#crashes.length <= CRASHES.limit) return true;
    this.#fail({ kind: "crashed", times: this.#crashes.length });
    return false;
  }

  #fail(problem: Problem): void {
    this.#problem = problem;
    this.set("failed");
    this.#failed.fire(problem);
  }

  protected override stepFailed(error: unknown): void {
    this.log.error(String(error));
  }
}
