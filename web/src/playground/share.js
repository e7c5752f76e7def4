// The texts in the address: compressed, behind the number sign, so that no host ever sees them.
const FORMAT = "deflate-raw";

/** @typedef {{ active: string, files: Record<string, string> }} State the name of the text that is shown, and texts by name */

/** @param {State} state */
export async function toFragment(state) {
  const stream = new Blob([JSON.stringify(state)]).stream().pipeThrough(new CompressionStream(FORMAT));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const text = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/**
 * What a fragment holds, undefined for one that is not ours.
 * @param {string} fragment
 * @returns {Promise<State | undefined>}
 */
export async function fromFragment(fragment) {
  if (fragment === "") return undefined;
  try {
    const text = atob(fragment.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(text, (character) => character.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(FORMAT));
    const state = JSON.parse(await new Response(stream).text());
    const files = Object.entries(state.files).filter(([, content]) => typeof content === "string");
    return files.length > 0 ? { active: String(state.active), files: Object.fromEntries(files) } : undefined;
  } catch {
    return undefined;
  }
}
