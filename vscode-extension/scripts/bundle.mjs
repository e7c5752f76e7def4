// Put the server and its pure-Python libraries into bundled/libs.
//
// NumPy and meshcat are left out: NumPy is bound to a platform, and both come from the user's interpreter.
import { execFileSync } from "node:child_process";
import { cp, mkdir, readFile, readdir, rm } from "node:fs/promises";
import path from "node:path";

const libs = path.resolve("bundled/libs");
const python = process.env.PYTHON ?? "python3";
const superfluous = /^bin$|^__pycache__$|\.pyc$/;

await rm(libs, { recursive: true, force: true });
await mkdir(libs, { recursive: true });
await installLibraries();
await copyServer();
await prune(libs);

async function installLibraries() {
  const pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-compile", "--no-deps"];
  execFileSync(python, [...pip, "--target", libs, "--requirement", "requirements.txt"], { stdio: "inherit" });
  const natives = (await readdir(libs, { recursive: true })).filter((name) => /\.(so|pyd|dylib)$/.test(name));
  if (natives.length > 0) throw new Error(`not pure Python: ${natives.join(", ")}`);
}

async function copyServer() {
  const server = await readFile("../server/kindsl/__init__.py", "utf8");
  const version = /^__version__ = "(.+)"$/m.exec(server)?.[1];
  const own = JSON.parse(await readFile("package.json", "utf8")).version;
  if (version !== own) throw new Error(`the server has version ${version}, package.json ${own}`);
  await cp("../server/kindsl", path.join(libs, "kindsl"), { recursive: true });
  await cp("../grammar/kindsl.lark", path.join(libs, "kindsl/grammar/kindsl.lark"));
}

async function prune(folder) {
  for (const entry of await readdir(folder, { withFileTypes: true })) {
    const place = path.join(folder, entry.name);
    if (superfluous.test(entry.name)) await rm(place, { recursive: true });
    else if (entry.isDirectory()) await prune(place);
  }
}
