// What the editor's own Node runs where there is no Python: the language server over stdio, or `lint ARGUMENTS`.
import { loadImage } from "./image";
import { lint } from "./lint";
import { serve } from "./serve";

const [command, ...args] = process.argv.slice(2);

// What Pyodide starts and nobody waits for fails here, too.
process.on("uncaughtException", (error: unknown) => {
  process.stderr.write(`The built-in Python failed: ${String(error)}\n`);
  process.exit(2);
});

void start();

async function start(): Promise<void> {
  if (command === "lint") process.exit(lint(await loadImage(__dirname), args));
  await serve(loadImage(__dirname));
}
