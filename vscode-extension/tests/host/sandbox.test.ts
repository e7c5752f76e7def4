// What Python in the editor's Node can reach: nothing but the folders that are open, and these to read only.
import assert from "node:assert/strict";
import * as fs from "node:fs";
import { createServer } from "node:net";
import * as os from "node:os";
import * as path from "node:path";
import { before, test } from "node:test";
import { loadImage } from "../../src/host/image";
import type { Pyodide } from "../../src/host/pyodide";
import { ReadOnlyFiles } from "../../src/host/readOnlyFiles";

const work = fs.realpathSync(fs.mkdtempSync(path.join(os.tmpdir(), "kindsl-host-")));
const project = path.join(work, "project"), folder = path.join(project, "models"), other = path.join(work, "other");
const secret = path.join(work, "secret.txt");
let py: Pyodide;
let files: ReadOnlyFiles;
const heard: string[] = [];
const listening = createServer(() => heard.push("a connection")).listen(0, "127.0.0.1").unref();

before(async () => {
  for (const name of [path.join(folder, "deep"), path.join(project, "beside"), other]) fs.mkdirSync(name, { recursive: true });
  fs.writeFileSync(secret, "secret");
  fs.writeFileSync(path.join(project, "notes.txt"), "secret");
  fs.writeFileSync(path.join(project, "beside", "kindsl.toml"), "secret");
  fs.writeFileSync(path.join(project, "kindsl.toml"), "ignore = []\n");
  fs.writeFileSync(path.join(folder, "arm.kindsl"), "Robot arm {}\n");
  fs.writeFileSync(path.join(folder, "deep", "leg.kindsl"), "x".repeat(100_000) + "end");
  fs.symlinkSync(secret, path.join(folder, "absolute.kindsl"));
  fs.symlinkSync("../notes.txt", path.join(folder, "relative.kindsl"));
  fs.symlinkSync("/etc", path.join(folder, "etc"));
  fs.symlinkSync("../..", path.join(folder, "up"));
  fs.symlinkSync("deep/leg.kindsl", path.join(folder, "within.kindsl"));
  fs.writeFileSync(path.join(other, "loose.kindsl"), "Robot loose {}\n");
  fs.mkdirSync(path.join(other, "below"));
  fs.writeFileSync(path.join(other, "below", "leg.kindsl"), "secret");
  py = await loadImage(path.resolve("server"));
  files = new ReadOnlyFiles(py);
  files.addFolder(folder);
});

/** The value of an expression, or the name of the error that it raises. */
function python(code: string): unknown {
  const name = "kindsl_answer";
  py.runPython(`
import os, json
from pathlib import Path
folder, project, work, secret, other = map(Path, ${JSON.stringify([folder, project, work, secret, other])})
try:
    ${name} = json.dumps(${code})
except Exception as error:
    ${name} = json.dumps(type(error).__name__ + (f" {os.strerror(error.errno)}" if isinstance(error, OSError) and error.errno else ""))`);
  return JSON.parse(String(py.runPython(name)));
}

test("the files of an open folder are there, at their own paths", () => {
  assert.equal(python("(folder / 'arm.kindsl').read_text()"), "Robot arm {}\n");
  assert.deepEqual(python("sorted(os.listdir(folder))"), fs.readdirSync(folder).sort());
  assert.equal(python("len((folder / 'deep' / 'leg.kindsl').read_bytes())"), 100_003);
  assert.equal(python("(lambda f: (f.seek(-3, 2), f.read())[1])(open(folder / 'deep' / 'leg.kindsl', 'rb')).decode()"), "end");
  assert.equal(python("os.stat(folder / 'arm.kindsl').st_size"), 13);
  assert.deepEqual(python("sorted(str(p.relative_to(folder)) for p in folder.rglob('leg*'))"), ["deep/leg.kindsl"]);
});

test("what changes on the disk is seen, another kind of thing under the same name included", () => {
  const place = path.join(folder, "changing"), code = "(folder / 'changing').read_text() if (folder / 'changing').is_file() else os.listdir(folder / 'changing')";
  assert.equal(python(code), "FileNotFoundError No such file or directory");
  fs.writeFileSync(place, "one");
  assert.equal(python(code), "one");
  fs.rmSync(place);
  fs.mkdirSync(place);
  assert.deepEqual(python(code), []);
  fs.rmdirSync(place);
  fs.symlinkSync(other, place);
  assert.equal(python("os.listdir(folder / 'changing')"), "FileNotFoundError No such file or directory");
  fs.rmSync(place);
});

test("the configuration above an open folder is there, and nothing else that is beside it", () => {
  assert.equal(python("(project / 'kindsl.toml').read_text()"), "ignore = []\n");
  assert.deepEqual(python("sorted(os.listdir(project))"), ["kindsl.toml", "models"]);
  for (const place of ["project / 'notes.txt'", "project / 'beside'", "project / 'beside' / 'kindsl.toml'", "secret", "other"]) {
    assert.equal(python(`(${place}).exists()`), false, place);
  }
});

test("links that lead out lead nowhere, those within are followed", () => {
  for (const name of ["absolute.kindsl", "relative.kindsl", "etc/passwd", "up/secret.txt", "up/other/loose.kindsl"]) {
    assert.equal(python(`(folder / '${name}').read_text()`), "FileNotFoundError No such file or directory", name);
  }
  assert.equal(python("len((folder / 'within.kindsl').read_text())"), 100_003);
  assert.equal(python("(folder / 'deep' / '..' / '..' / '..' / 'secret.txt').exists()"), false);
});

test("nothing else of the disk is there", () => {
  for (const place of ["/etc/passwd", "/proc/self/environ", "/root", "/usr", os.homedir(), process.execPath, path.resolve("server")]) {
    assert.equal(python(`os.path.exists(${JSON.stringify(place)})`), false, place);
  }
});

test("nothing can be written, made, moved or deleted", () => {
  const before = fs.readdirSync(folder).sort();
  const refused: unknown[] = [
    "open(folder / 'arm.kindsl', 'w')", "open(folder / 'arm.kindsl', 'a')", "open(folder / 'arm.kindsl', 'r+')",
    "open(folder / 'new.kindsl', 'x')", "os.mkdir(folder / 'new')", "os.remove(folder / 'arm.kindsl')",
    "os.rename(folder / 'arm.kindsl', folder / 'b.kindsl')", "os.rename(folder / 'arm.kindsl', '/b')", "os.rmdir(folder / 'deep')",
    "os.symlink('arm.kindsl', folder / 'b.kindsl')",
    "os.truncate(folder / 'arm.kindsl', 0)", "os.chmod(folder / 'arm.kindsl', 0o777)", "os.utime(folder / 'arm.kindsl')",
    "open(project / 'kindsl.toml', 'w')", "os.mkdir(project / 'new')",
  ].map((code) => [code, String(python(code)).replace(/ .*/, "")]).filter(([, answer]) => !["OSError", "PermissionError"].includes(String(answer)));
  assert.deepEqual(refused, []);
  assert.deepEqual(fs.readdirSync(folder).sort(), before);
  assert.equal(fs.readFileSync(path.join(folder, "arm.kindsl"), "utf8"), "Robot arm {}\n");
  assert.equal(fs.statSync(path.join(folder, "arm.kindsl")).mode & 0o111, 0);
});

test("files that were opened in vain are closed again", () => {
  python("[open(folder / 'arm.kindsl').close() for _ in range(5000)]");
  for (let count = 0; count < 5; count++) python("[os.open(folder / 'arm.kindsl', os.O_WRONLY) for _ in range(5000)]");
  assert.equal(python("(folder / 'arm.kindsl').read_text()"), "Robot arm {}\n");
});

test("the files beside a document of no folder are there, the folders beside it are not", () => {
  files.addDocument(path.join(other, "loose.kindsl"));
  assert.equal(python("(other / 'loose.kindsl').read_text()"), "Robot loose {}\n");
  assert.deepEqual(python("os.listdir(other)"), ["loose.kindsl"]);
  assert.equal(python("(other / 'below' / 'leg.kindsl').exists()"), false);
});

test("a folder that is closed is gone", () => {
  const added = path.join(work, "project", "beside");
  files.addFolder(added);
  assert.equal(python("(project / 'beside' / 'kindsl.toml').exists()"), true);
  files.removeFolder(added);
  assert.equal(python("(project / 'beside' / 'kindsl.toml').exists()"), false);
});

test("the folders that Python itself lives in stay its own", () => {
  for (const place of ["/lib", "/dev", "/proc"]) files.addFolder(place);
  assert.equal(python("os.path.exists('/lib/site.zip')"), true);
  assert.equal(python("os.path.exists('/proc/self/environ')"), false);
});

test("no process is started, and nothing of Node's can be named", () => {
  const mark = path.join(folder, "mark");
  for (const code of [`os.system('touch ${mark}')`, `__import__('subprocess').run(['touch', '${mark}'])`, `os.posix_spawn('/bin/touch', ['touch', '${mark}'], {})`]) {
    assert.notEqual(python(code), 0, code);
  }
  assert.equal(fs.existsSync(mark), false);
  assert.equal(python("dir(__import__('js')) and hasattr(__import__('js'), 'process')"), false);
  assert.equal(python("__import__('js').constructor"), "AttributeError");
  assert.equal(python("__import__('pyodide_js')"), "ModuleNotFoundError");
  assert.equal(python("__import__('pyodide.code').code.run_js('process')"), "ImportError");
  assert.equal(python("'PATH' in os.environ and os.environ['PATH']"), "/");
});

test("no connection is opened", async () => {
  const { port } = listening.address() as { port: number };
  for (const code of [
    `__import__('socket').create_connection(('127.0.0.1', ${port}), 1).close()`,
    `__import__('urllib.request').request.urlopen('http://127.0.0.1:${port}').status`,
    `__import__('pyodide.http').http.open_url('http://127.0.0.1:${port}')`,
  ]) {
    assert.match(String(python(code)), /Error/, code);
  }
  await new Promise((resolve) => setTimeout(resolve, 100));
  assert.deepEqual(heard, []);
});
