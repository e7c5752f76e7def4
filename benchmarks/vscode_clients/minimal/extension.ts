// The least client of a language server: the baseline of the activation benchmark.
import { LanguageClient } from "vscode-languageclient/node";

export async function activate(): Promise<void> {
  const command = process.env["KINDSL_BENCHMARK_PYTHON"] ?? "python3";
  const server = { command, args: [process.env["KINDSL_BENCHMARK_SERVER"] ?? ""] };
  const client = new LanguageClient("minimal", "Minimal", server, { documentSelector: [{ language: "plaintext" }] });
  await client.start();
}
