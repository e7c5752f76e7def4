// The picture as a PNG file: ground colour, robot and names.

/** @import { Viewer } from "../base/types.js" */
/** @import { Labels } from "./labels.js" */

/**
 * Return a canvas with what the pane shows.
 * @param {Viewer} viewer
 * @param {Labels} labels
 * @param {HTMLElement} pane
 */
export function drawPicture(viewer, labels, pane) {
  viewer.render();
  const source = viewer.renderer.domElement, canvas = document.createElement("canvas");
  Object.assign(canvas, { width: source.width, height: source.height });
  const pen = canvas.getContext("2d"), scale = source.width / pane.clientWidth, style = getComputedStyle(document.documentElement);
  if (!pen) throw new Error("this browser draws no canvas");
  const color = (/** @type {string} */ name) => style.getPropertyValue(`--${name}`).trim();
  const sky = pen.createLinearGradient(0, 0, 0, canvas.height);
  sky.addColorStop(0, color("sky"));
  sky.addColorStop(1, color("floor"));
  pen.fillStyle = sky;
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.filter = getComputedStyle(source).filter; // that of what is out of date
  pen.drawImage(source, 0, 0);
  pen.filter = "none";
  pen.scale(scale, scale);
  drawSentence(pen, pane, color);
  drawNames(pen, labels, pane.getBoundingClientRect(), color);
  return canvas;
}

/**
 * What is said over the picture: that it is not of the present document, or not all of it.
 * @param {CanvasRenderingContext2D} pen
 * @param {HTMLElement} pane
 * @param {(name: string) => string} color
 */
function drawSentence(pen, pane, color) {
  /** @type {HTMLElement | null} */
  const notice = pane.querySelector("#notice:not([hidden])");
  if (!notice) return;
  pen.font = "12px system-ui, DejaVu Sans, sans-serif";
  pen.textBaseline = "top";
  pen.fillStyle = color("ink");
  pen.fillText((notice.textContent ?? "").trim(), 12, 10, pane.clientWidth - 24);
}

/**
 * @param {CanvasRenderingContext2D} pen
 * @param {Labels} labels
 * @param {DOMRect} pane
 * @param {(name: string) => string} color
 */
function drawNames(pen, labels, { left, top }, color) {
  pen.font = "11px system-ui, DejaVu Sans, sans-serif";
  pen.textBaseline = "middle";
  const names = [...labels.byKey.values()].filter(({ isShown }) => isShown).map(({ element, name }) => ({ element, name }));
  /** @type {NodeListOf<HTMLElement>} */
  const robots = labels.pane.querySelectorAll(".compared:not([hidden])");
  for (const { element, name } of [...names, ...[...robots].map((tag) => ({ element: tag, name: tag.textContent ?? "" }))]) {
    if (!element) continue;
    const box = element.getBoundingClientRect(), look = getComputedStyle(element);
    pen.fillStyle = look.backgroundColor;
    pen.fillRect(box.left - left, box.top - top, box.width, box.height);
    pen.fillStyle = look.borderLeftColor;
    pen.fillRect(box.left - left, box.top - top, 2, box.height);
    pen.fillStyle = look.color || color("ink");
    pen.fillText(name, box.left - left + 6, box.top - top + box.height / 2, box.width - 8);
  }
}

/** @param {HTMLCanvasElement} canvas @param {string} name */
export function savePicture(canvas, name) {
  canvas.toBlob((blob) => {
    if (!blob) return;
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = `${name.replace(/[^\w.-]+/g, "_") || "robot"}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  });
}
