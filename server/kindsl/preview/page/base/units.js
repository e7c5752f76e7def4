// Values as people type and read them: 45deg, 90°, PI/4, 30 mm, 2*(0.1 + 5 cm). Inside there are radians and metres.
import { format } from "./elements.js";

export const DEGREE = Math.PI / 180;
/** @typedef {{ readonly number?: number, readonly word?: string, readonly sign?: string }} Token */
/** @typedef {{ readonly tokens: readonly Token[], at: number, depth: number, isBare: boolean }} Reader */

/** @type {Readonly<Record<string, number>>} */
const FACTORS = { rad: 1, deg: DEGREE, "°": DEGREE, m: 1, cm: 0.01, mm: 0.001, kg: 1, g: 0.001 };
const TOKEN = /\s*(?:(\d+(?:[.,]\d*)?(?:e[+-]?\d+)?|[.,]\d+(?:e[+-]?\d+)?)|(°|[a-zπ]+)|([-+*/()]))/iy;
const DEEPEST = 50; // brackets

/**
 * Return {value, isBare}: SI units, and whether neither a unit nor PI was named; null if it is no value.
 * @param {string} text
 */
export function parseValue(text) {
  const tokens = tokenize(text);
  if (!tokens) return null;
  const reader = { tokens, at: 0, depth: 0, isBare: true };
  const value = sum(reader);
  return reader.at === tokens.length && Number.isFinite(value) ? { value, isBare: reader.isBare } : null;
}

/** @param {string} text */
function tokenize(text) {
  /** @type {Token[]} */
  const tokens = [];
  const source = text.trim();
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < source.length) {
    const found = TOKEN.exec(source);
    if (!found) return null;
    const [, number, word, sign] = found;
    tokens.push(number ? { number: Number(number.replace(",", ".")) } : { word: word?.toLowerCase(), sign });
  }
  return tokens.length ? tokens : null;
}

/** @param {Reader} reader @returns {number} */
function sum(reader) {
  let value = product(reader);
  for (let sign = take(reader, "+-"); sign; sign = take(reader, "+-")) {
    const next = product(reader);
    value = sign === "+" ? value + next : value - next;
  }
  return value;
}

/** @param {Reader} reader @returns {number} */
function product(reader) {
  let value = signed(reader);
  for (let sign = take(reader, "*/"); sign; sign = take(reader, "*/")) {
    const next = signed(reader);
    value = sign === "*" ? value * next : value / next;
  }
  return value;
}

/** @param {Reader} reader @returns {number} */
function signed(reader) {
  const sign = take(reader, "+-");
  if (!sign) return measured(reader);
  reader.depth += 1;
  return reader.depth > DEEPEST ? NaN : (sign === "-" ? -1 : 1) * signed(reader);
}

/**
 * A number, PI or a bracket, with its unit.
 * @param {Reader} reader
 * @returns {number}
 */
function measured(reader) {
  let value = atom(reader);
  for (let token = reader.tokens[reader.at]; token?.word; token = reader.tokens[reader.at]) {
    const factor = isPi(token) ? Math.PI : FACTORS[token.word];
    if (factor === undefined) return NaN;
    value *= factor;
    reader.isBare = false;
    reader.at += 1;
  }
  return value;
}

/** @param {Reader} reader @returns {number} */
function atom(reader) {
  const token = reader.tokens[reader.at];
  if (!token) return NaN;
  reader.at += 1;
  if (token.number !== undefined) return token.number;
  if (isPi(token)) {
    reader.isBare = false;
    return Math.PI;
  }
  if (token.sign !== "(" || ++reader.depth > DEEPEST) return NaN;
  const value = sum(reader);
  return take(reader, ")") ? value : NaN;
}

/** @param {Token} token */
const isPi = ({ word }) => word === "pi" || word === "π";

/** @param {Reader} reader @param {string} signs */
function take(reader, signs) {
  const token = reader.tokens[reader.at];
  if (!token?.sign || !signs.includes(token.sign)) return null;
  reader.at += 1;
  return token.sign;
}

// What values are read and shown in. `kind` is "angle", "length", or anything that has no unit here.
export class Units {
  /** @type {"rad" | "deg"} */
  angle = "rad";
  /** @type {(() => void)[]} */
  #listeners = [];

  /** @param {() => void} listener */
  onChange(listener) { this.#listeners.push(listener); }

  /** @param {string} angle */
  choose(angle) {
    this.angle = angle === "deg" ? "deg" : "rad";
    for (const listener of this.#listeners) listener();
  }

  /** @param {string} kind */
  nameOf(kind) { return kind === "angle" ? this.angle : kind === "length" ? "m" : ""; }

  /**
   * The value in radians, metres or kilograms; null if the text is no value.
   * @param {string} text
   * @param {string} kind
   */
  read(text, kind) {
    const found = parseValue(text);
    if (!found) return null;
    return found.isBare && kind === "angle" && this.angle === "deg" ? found.value * DEGREE : found.value;
  }

  /** @param {number} value @param {string} kind */
  show(value, kind) {
    const isDegrees = kind === "angle" && this.angle === "deg";
    return format(isDegrees ? value / DEGREE : value, isDegrees ? 2 : 4);
  }
}
