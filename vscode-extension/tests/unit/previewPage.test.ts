import assert from "node:assert/strict";
import { test } from "node:test";
import { previewPage } from "../../src/previewPage";

const state = { uri: "file:///a.kindsl", isPinned: false };

test("the frame shows the address unchanged, and only its origin may be framed", () => {
  const page = previewPage({ kind: "frame", url: "http://127.0.0.1:4321/?token=a=b&x=1" }, state, "n");
  assert.match(page, /<iframe [^>]*src="http:\/\/127\.0\.0\.1:4321\/\?token=a=b&amp;x=1"/);
  assert.match(page, /frame-src http:\/\/127\.0\.0\.1:4321[";]/);
  assert.match(page, /default-src &#39;none&#39;/);
});

test("a message is text, and then nothing may be framed", () => {
  const page = previewPage({ kind: "message", text: "<b>no</b>", actions: ["Try <it>"] }, state, "n");
  assert.match(page, /<p>&lt;b&gt;no&lt;\/b&gt;<\/p>/);
  assert.match(page, /<button>Try &lt;it&gt;<\/button>/);
  assert.doesNotMatch(page, /frame-src|<iframe/);
});

test("a file name cannot end the script", () => {
  const page = previewPage({ kind: "message", text: "", actions: [] }, { uri: "file:///</script><x>", isPinned: true }, "n");
  assert.equal(page.match(/<\/script>/g)?.length, 1);
});

test("an address that is none is refused", () => {
  assert.throws(() => previewPage({ kind: "frame", url: "no address" }, state, "n"), TypeError);
});

test("the frame is told the theme, and nobody else is", () => {
  const html = previewPage({ kind: "frame", url: "http://127.0.0.1:4000/?token=abc" }, state, "n0nce");
  assert.match(html, /return \{ type: "kindsl\.theme"[^]*postMessage\(read\(\), "http:\/\/127\.0\.0\.1:4000"\)/);
  assert.doesNotMatch(previewPage({ kind: "message", text: "none", actions: [] }, state, "n0nce"), /kindsl\.theme/);
});
