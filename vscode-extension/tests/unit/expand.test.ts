import assert from "node:assert/strict";
import { test } from "node:test";
import { expand } from "../../src/expand";

const places = { home: "/home/ada", workspaceFolder: "/w", env: { VENV: "/v" } };

test("a tilde at the beginning is the home folder", () => {
  assert.equal(expand("~/bin/python", places), "/home/ada/bin/python");
  assert.equal(expand("~", places), "/home/ada");
});

test("a tilde elsewhere is a tilde", () => {
  assert.equal(expand("/opt/~x", places), "/opt/~x");
  assert.equal(expand("~bob/python", places), "~bob/python");
});

test("variables", () => {
  assert.equal(expand("${workspaceFolder}/.venv", places), "/w/.venv");
  assert.equal(expand("${env:VENV}:${userHome}", places), "/v:/home/ada");
});

test("what has no value stays", () => {
  assert.equal(expand("${env:NONE} ${workspaceFolder}", { home: "/h", env: {} }), "${env:NONE} ${workspaceFolder}");
});

test("a dollar sign in a value is not a pattern", () => {
  assert.equal(expand("~/a", { home: "/$&", env: {} }), "/$&/a");
});
