"""Facts about a picture, computed by the browser, which can read its own."""

import base64

from playwright.sync_api import Page

_COLOURS = """async (encoded) => {
  const bytes = Uint8Array.from(atob(encoded), (character) => character.charCodeAt(0));
  const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  const context = canvas.getContext("2d");
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
  const pixels = new Uint32Array(data.buffer);
  const counts = new Map();
  for (const pixel of pixels) counts.set(pixel, (counts.get(pixel) || 0) + 1);
  return [counts.size, Math.max(...counts.values()) / pixels.length];
}"""


def colours(page: Page, png: bytes) -> tuple[int, float]:
    """Return how many colours a picture has, and the share of the commonest one."""
    count, share = page.evaluate(_COLOURS, base64.b64encode(png).decode())
    return count, share
