import assert from "node:assert/strict";
import { chmod, mkdtemp, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
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
