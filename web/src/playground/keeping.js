// The texts, kept in the browser as one types: by address, since each shared link has texts of its own. What this tab
// has is kept apart from what any tab had last, so that two tabs do not take each other's texts at a reload.

/** @typedef {{ readonly text: string, readonly original: string }} Kept a text, and the one that was opened */
/** @typedef {{ readonly active: string, readonly files: Readonly<Record<string, Kept>>, readonly time: number }} Session by name; milliseconds */
/** @typedef {Pick<Storage, "getItem" | "setItem" | "removeItem" | "key" | "length">} Store */

const PREFIX = "kindsl ";
const MOST = 12; // shared links
/** @type {Record<string, Kept>} */
const NO_FILES = {};

/**
 * The name under which the texts of an address are kept: one's own, or those of a shared link.
 * @param {{ readonly pathname: string, readonly hash: string }} address
 */
export const keyOf = ({ pathname, hash }) => PREFIX + pathname + (hash.length > 1 ? `#${digest(hash)}` : "");

export class Keeping {
  /** Whether what is written is not kept for another visit: forbidden, or no room. */
  hasFailed = false;

  /** @param {Store | undefined} ofTab @param {Store | undefined} ofAll */
  constructor(ofTab, ofAll) {
    this.ofTab = ofTab;
    this.ofAll = ofAll;
  }

  /**
   * What was kept for an address; undefined for nothing that can be read.
   * @param {string} key
   * @returns {Session | undefined}
   */
  read(key) {
    return sessionIn(this.ofTab, key) ?? sessionIn(this.ofAll, key);
  }

  /** @param {string} key @param {Session} session */
  write(key, session) {
    const text = JSON.stringify(session);
    put(this.ofTab, key, text);
    this.hasFailed = !put(this.ofAll, key, text);
  }

  /** @param {string} key */
  forget(key) {
    for (const store of [this.ofTab, this.ofAll]) store?.removeItem(key);
  }
}

/** @param {Store | undefined} store @param {string} key @returns {Session | undefined} */
function sessionIn(store, key) {
  try {
    const { active, files, time } = JSON.parse(store?.getItem(key) ?? "null") ?? { files: NO_FILES };
    const whole = Object.entries(files).filter(([, file]) => typeof file?.text === "string" && typeof file.original === "string");
    return whole.length > 0 ? { active: String(active), files: Object.fromEntries(whole), time: Number(time) || 0 } : undefined;
  } catch {
    return undefined;
  }
}

/**
 * Write, and forget the shared link that was written longest ago if there are too many.
 * @param {Store | undefined} store
 * @param {string} key
 * @param {string} text
 */
function put(store, key, text) {
  try {
    if (!store) return false;
    store.setItem(key, text);
    const links = Array.from({ length: store.length }, (_, index) => store.key(index) ?? "").filter((name) => name.startsWith(PREFIX) && name.includes("#"));
    const time = (/** @type {string} */ name) => sessionIn(store, name)?.time ?? 0;
    if (links.length > MOST) store.removeItem(links.reduce((a, b) => (time(a) <= time(b) ? a : b)));
    return true;
  } catch {
    return false;
  }
}

/**
 * A few letters for a long text.
 * @param {string} text
 */
function digest(text) {
  let [a, b] = [0x9e3779b9, 0x85ebca6b];
  for (let i = 0; i < text.length; i++) {
    a = Math.imul(a ^ text.charCodeAt(i), 2654435761);
    b = Math.imul(b ^ text.charCodeAt(i), 1597334677);
  }
  return (a >>> 0).toString(36) + (b >>> 0).toString(36);
}

/**
 * A store of the browser; undefined where it is forbidden.
 * @param {() => Storage} get
 */
export function storeOf(get) {
  try {
    return get();
  } catch {
    return undefined;
  }
}
