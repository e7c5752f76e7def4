// The title and icon of the browser's tab: whose robot it is, and how it is.
import { partOf } from "../base/elements.js";

/**
 * @typedef {object} Told
 * @property {string} name The robot's.
 * @property {readonly string[]} words How many findings there are, the worst first.
 * @property {{ readonly [severity: string]: number }} counts
 * @property {string} state Of the picture.
 * @property {string} connection
 */

const COLORS = { good: "#2f9e5b", warning: "#c98a1b", error: "#c0392b", lost: "#8a94a0" };

/** @param {Told} told */
export function showTitle({ name, words, counts, state, connection }) {
  const isLost = state === "gone" || connection === "reconnecting";
  const look = isLost ? "lost" : counts.error ? "error" : counts.warning ? "warning" : "good";
  const title = [name || "Robot", counts.error ? `(${words[0]})` : "", isLost ? "(not connected to its file)" : ""];
  document.title = `${title.filter(Boolean).join(" ")} – kindsl preview`;
  /** @type {HTMLLinkElement} */
  const icon = partOf(document, "link[rel=icon]");
  const address = picture(COLORS[look]);
  if (icon.href !== address) icon.href = address;
  icon.dataset.look = look;
}

/**
 * Two links and a joint.
 * @param {string} color
 */
function picture(color) {
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 16"><path d="M3 14V7l8-4" fill="none" stroke="${color}" `
    + `stroke-width="3" stroke-linecap="round" stroke-linejoin="round"/><circle cx="3" cy="7" r="2.6" fill="${color}"/></svg>`;
  return `data:image/svg+xml,${encodeURIComponent(svg)}`;
}
