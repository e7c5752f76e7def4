// Values as people type and read them: 45deg, 90°, PI/4, 30 mm, 2*(0.1 + 5 cm). Inside there are radians and metres.
import { format } from "./elements.js";

export const DEGREE = Math.PI / 180;
/** @typedef {{ readonly number?: number, readonly word?: string, readonly sign?: string }} Token */
/** @typedef {{ readonly tokens: readonly Token[], at: number, depth: number, isBare: boolean }} Reader */

/** @typedef {{ readonly value: number, readonly isBare: boolean } | { readonly reason: string }} Read */

/** @type {Readonly<Record<string, number>>} */
const FACTORS = { rad: 1, deg: DEGREE, "°": DEGREE, m: 1, cm: 0.01, mm: 0.001, kg: 1, g: 0.001 };
/** @type {Readonly<Record<string, readonly [name: string, units: readonly string[]]>>} */
const FITTING = { angle: ["an angle", ["rad", "deg", "°"]], length: ["a length", ["m", "cm", "mm"]], dynamics: ["a mass or moment", ["kg", "g", "m", "cm", "mm"]] };
const TOKEN = /\s*(?:(\d+(?:[.,]\d*)?(?:e[+-]?\d+)?|[.,]\d+(?:e[+-]?\d+)?)|(°|[a-zπ]+)|([-+*/()]))/iy;
const DEEPEST = 50; // brackets

/**
 * The value in SI units, and whether neither a unit nor PI was named; or why it is no value of this kind.
 * @param {string} text
 * @param {string} kind
 * @returns {Read}
 */
export function parseValue(text, kind) {
  const tokens = tokenize(text), strange = misfit(tokens ?? [], kind);
  if (strange) return { reason: strange };
  const reader = { tokens: tokens ?? [], at: 0, depth: 0, isBare: true };
  const value = sum(reader);
  return reader.at === reader.tokens.length && Number.isFinite(value) ? { value, isBare: reader.isBare } : { reason: "not a number" };
}

/**
 * Why a unit does not fit; empty if all do.
 * @param {readonly Token[]} tokens
 * @param {string} kind
 */
function misfit(tokens, kind) {
  const [name, units] = FITTING[kind] ?? ["this", Object.keys(FACTORS)];
  const wrong = tokens.find((token) => token.word && !isPi(token) && !units.includes(token.word))?.word;
  return wrong && `'${wrong}' is not a unit of ${name}: use ${units.join(", ")}`;
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
   * The value in radians, metres or kilograms, or why the text is none.
   * @param {string} text
   * @param {string} kind
   * @returns {Read}
   */
  read(text, kind) {
    const found = parseValue(text, kind);
    const isDegrees = "value" in found && found.isBare && kind === "angle" && this.angle === "deg";
    return isDegrees ? { ...found, value: found.value * DEGREE } : found;
  }

  /** @param {number} value @param {string} kind */
  show(value, kind) {
    const isDegrees = kind === "angle" && this.angle === "deg";
    return format(isDegrees ? value / DEGREE : value, isDegrees ? 2 : 4);
  }
}
