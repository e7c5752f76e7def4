// The life of the language server in a worker of the browser's extension host.
import * as vscode from "vscode";
import { LanguageClient } from "vscode-languageclient/browser";
import { RESTART, SHOW_LOG, showError } from "../actions";
import { clientOptions, LANGUAGE, OTHER_ROBOTS, rulePages, TRANSFORMS, type DocumentStatus, type Requests } from "../clientOptions";
import { PAGE_MESSAGES, PAGE_REQUEST, type PageMessages, type PageServer } from "../serverAccess";
import { ServerLife } from "../serverLife";
import { ProjectFiles } from "./projectFiles";

const READY = "kindsl/ready", FAILED = "kindsl/failed";

export class WorkerServer extends ServerLife<LanguageClient> implements PageServer {
  readonly #drawn = new vscode.EventEmitter<PageMessages>();
  readonly onPageMessages = this.#drawn.event;

  #worker: Worker | undefined;
  #files: ProjectFiles | undefined;

  constructor(
    private readonly extension: vscode.Uri,
    private readonly log: vscode.LogOutputChannel,
    private readonly requests: Requests,
  ) {
    super();
  }

  sendFromPage(document: string, request: unknown): void {
    if (this.state === "running") void this.current?.sendNotification(PAGE_REQUEST, { document, request });
  }

  override dispose(): void {
    super.dispose();
    this.#drawn.dispose();
  }

  protected override async begin(): Promise<void> {
    this.set("starting");
    const worker = (this.#worker = newWorker(this.extension));
    const files = (this.#files = new ProjectFiles());
    const client = (this.current = this.#newClient(worker, files));
    const broken = new Promise<never>((_, reject) => {
      worker.addEventListener("error", ({ message }) => reject(new Error(message)));
      client.onNotification(FAILED, ({ message }: { message: string }) => reject(new Error(message)));
    });
    await Promise.race([client.start(), broken]);
    this.set("running");
    files.follow(client);
  }

  #newClient(worker: Worker, files: ProjectFiles): LanguageClient {
    const options = {
      ...clientOptions(this.log, { ...this.requests, crashed: () => false, rules: rulePages(this.extension) }),
      documentSelector: [{ language: LANGUAGE }, { language: TRANSFORMS }, { pattern: OTHER_ROBOTS }, { pattern: "**/kindsl.toml" }],
      uriConverters: files.uriConverters,
    };
    const client = new LanguageClient("kindsl", "Kinematics-DSL", options, worker);
    client.onNotification("kindsl/status", (status: DocumentStatus) =>
      this.requests.showStatus({ ...status, uri: files.toEditor(status.uri).toString() }),
    );
    client.onNotification(PAGE_MESSAGES, (params: PageMessages) => this.#drawn.fire(params));
    client.onNotification(READY, ({ isImage, total }: { isImage: boolean; total: number }) =>
      this.log.info(`Python started in ${total} ms from ${isImage ? "its memory image" : "the packed sources"}`),
    );
    return client;
  }

  /** End the worker: it holds nothing that is not in the documents. */
  protected override async end(): Promise<void> {
    this.#files?.dispose();
    if (this.current?.isRunning()) await this.current.stop().catch((error) => this.log.warn(String(error)));
    this.#worker?.terminate();
    this.current = this.#worker = this.#files = undefined;
    this.set("stopped");
  }

  protected override stepFailed(error: unknown): void {
    const message = `The Kinematics-DSL server did not start in this browser: ${(error as Error).message}`;
    this.log.error(message);
    this.set("failed");
    void showError(message, [RESTART, SHOW_LOG]);
  }
}

/** A worker of another origin than the page's must come as a blob; what it imports may be anywhere. */
function newWorker(extension: vscode.Uri): Worker {
  const base = vscode.Uri.joinPath(extension, "server/").toString(true);
  const script = `importScripts(${JSON.stringify(`${base}worker.js`)})`;
  const worker = new Worker(URL.createObjectURL(new Blob([script], { type: "text/javascript" })));
  worker.postMessage({ base });
  return worker;
}
