import assert from "node:assert/strict";
import { chmod, mkdtemp, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import { installedPythons } from "../../src/installedPythons";
import { candidates, probeWith, search, type Command, type Interpreter, type Probe } from "../../src/python";

const posix = { configured: [], platform: "linux" } as const;

test("a configured interpreter is the only candidate, with its options", () => {
  const hints = { ...posix, configured: ["/p", "-X", "utf8"], selected: ["/ms"] as Command, trustedFolder: "/w" };
  assert.deepEqual(candidates(hints), [["/p", "-X", "utf8"]]);
});

test("without one: the Python extension's, the workspace's, the system's", () => {
  const hints = { ...posix, selected: ["/ms"] as Command, trustedFolder: "/w" };
  assert.deepEqual(candidates(hints), [["/ms"], ["/w/.venv/bin/python"], ["python3"], ["python"]]);
});

test("nothing is taken from a workspace that is not trusted", () => {
  assert.deepEqual(candidates(posix), [["python3"], ["python"]]);
});

test("Windows has a launcher", () => {
  assert.deepEqual(candidates({ configured: [], platform: "win32" }), [["py", "-3"], ["python"]]);
});

test("the first with NumPy wins over an earlier one without", async () => {
  const result = await search([["bare"], ["full"], ["other"]], answers({ bare: ["numpy"], full: [], other: [] }));
  assert.deepEqual(result.found?.command, ["full"]);
});

test("one without NumPy is better than none", async () => {
  const result = await search([["none"], ["bare"]], answers({ bare: ["numpy"] }));
  assert.deepEqual(result.found?.command, ["bare"]);
  assert.deepEqual(result.rejected, ["none: not found"]);
});

test("an old Python is rejected with its version", async () => {
  const probe: Probe = async (command) => ({ command, version: [3, 9, 2], missing: [] });
  assert.deepEqual(await search([["python3"]], probe), { rejected: ["python3: Python 3.9.2 is too old"] });
});

test("one that hangs delays the others for a moment only", async () => {
  const probe: Probe = (command) =>
    command[0] === "hangs"
      ? new Promise(() => undefined)
      : Promise.resolve({ command, version: [3, 12, 0], missing: [] });
  const result = await search([["hangs"], ["python3"]], probe, 5);
  assert.deepEqual(result.found?.command, ["python3"]);
  assert.deepEqual(result.rejected, ["hangs: does not answer"]);
});

test("one that hangs delays what comes when there is no other for a moment only", async () => {
  const probe: Probe = (command) => (command[0] === "hangs" ? new Promise(() => undefined) : Promise.reject(new Error("not found")));
  const result = await search([["hangs"], ["none"]], probe, 5);
  assert.deepEqual(result, { rejected: ["hangs: does not answer", "none: not found"] });
});

test("Pythons are found where tools install them, the newest first", async () => {
  const folders: Record<string, string[]> = {
    "/home/u/.pyenv/versions": ["3.9.1", "3.12.4", "3.11.7"],
    "/home/u/.local/share/uv/python": ["cpython-3.13.0-linux"],
    "/home/u/miniforge3": ["bin"],
    "/home/u/miniforge3/envs": ["ros"],
    "/usr/bin": ["python3", "python3.10", "python3.12", "python3.12-config"],
  };
  const disk = { home: "/home/u", env: {}, list: async (folder: string) => folders[folder] ?? [] };
  const found = (await installedPythons(disk, "linux")).map(([program]) => program);
  assert.deepEqual(found, [
    "python3.14", "python3.13", "python3.12", "python3.11",
    "/home/u/.pyenv/versions/3.12.4/bin/python3", "/home/u/.pyenv/versions/3.11.7/bin/python3",
    "/home/u/.pyenv/versions/3.9.1/bin/python3", "/home/u/.local/share/uv/python/cpython-3.13.0-linux/bin/python3",
    "/home/u/miniforge3/bin/python3", "/home/u/miniforge3/envs/ros/bin/python3",
    "/usr/bin/python3.12", "/usr/bin/python3.10",
  ]);
  assert.deepEqual(await installedPythons(disk, "win32"), []);
});

test("the probe tells a missing program from one that is no Python and from one that fails", async () => {
  const probe = probeWith("/dev/null");
  await assert.rejects(probe(["/nowhere/python"]), /not found/);
  await assert.rejects(probe(["echo"]), /is no Python/);
  await assert.rejects(probe([await script("echo broken pipe organ >&2; exit 3")]), /broken pipe organ/);
});

test("the probe reads what the script prints", async () => {
  const program = await script(`echo '{"version": [3, 12, 1], "missing": ["numpy"]}'`);
  assert.deepEqual(await probeWith("x")([program]), { command: [program], version: [3, 12, 1], missing: ["numpy"] });
});

function answers(missing: Record<string, string[]>): Probe {
  return async (command): Promise<Interpreter> => {
    const packages = missing[command[0]];
    if (packages === undefined) throw new Error("not found");
    return { command, version: [3, 11, 0], missing: packages };
  };
}

async function script(body: string): Promise<string> {
  const program = path.join(await mkdtemp(path.join(tmpdir(), "kindsl-")), "program");
  await writeFile(program, `#!/bin/sh\n${body}\n`);
  await chmod(program, 0o755);
  return program;
}
