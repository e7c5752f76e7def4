// A panel that shows the page which the server serves, or is the page itself where the server serves none.
import * as vscode from "vscode";
import { FrameScreen } from "./frameScreen";
import { PageScreen } from "./pageScreen";
import type { Screen } from "./preview";
import type { PanelState } from "./previewPage";
import type { Server } from "./server";

export class EitherScreen implements Screen {
  #screen: FrameScreen | PageScreen | undefined;

  constructor(
    private readonly panel: vscode.WebviewPanel,
    private readonly server: Server,
    private readonly page: Promise<string>,
  ) {}

  async show(uri: vscode.Uri, state: PanelState): Promise<void> {
    await this.server.client();
    const Kind = this.server.isBuiltIn && this.server.problem === undefined ? PageScreen : FrameScreen;
    if (!(this.#screen instanceof Kind)) {
      this.#screen?.dispose();
      this.#screen = Kind === PageScreen ? new PageScreen(this.panel, this.server, this.page) : new FrameScreen(this.panel, this.server);
    }
    await this.#screen.show(uri, state);
  }

  dispose(): void {
    this.#screen?.dispose();
  }
}
