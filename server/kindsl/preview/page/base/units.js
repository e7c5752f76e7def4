// Values as people type and read them: 45deg, 90°, PI/4, 30 mm, 2*(0.1 + 5 cm). Inside there are radians and metres.
import { format } from "./elements.js";

export const DEGREE = Math.PI / 180;
const FACTORS = { rad: 1, deg: DEGREE, "°": DEGREE, m: 1, cm: 0.01, mm: 0.001, kg: 1, g: 0.001 };
const TOKEN = /\s*(?:(\d+(?:[.,]\d*)?(?:e[+-]?\d+)?|[.,]\d+(?:e[+-]?\d+)?)|(°|[a-zπ]+)|([-+*/()]))/iy;
const DEEPEST = 50; // brackets

// Return {value, isBare}: SI units, and whether neither a unit nor PI was named; null if it is no value.
export function parseValue(text) {
  const tokens = tokenize(text);
  if (!tokens) return null;
  const reader = { tokens, at: 0, depth: 0, isBare: true };
  const value = sum(reader);
  return reader.at === tokens.length && Number.isFinite(value) ? { value, isBare: reader.isBare } : null;
}

function tokenize(text) {
  const tokens = [], source = text.trim();
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < source.length) {
    const found = TOKEN.exec(source);
    if (!found) return null;
    const [, number, word, sign] = found;
    tokens.push(number ? { number: Number(number.replace(",", ".")) } : { word: word && word.toLowerCase(), sign });
  }
  return tokens.length ? tokens : null;
}

function sum(reader) {
  let value = product(reader);
  for (let sign = take(reader, "+-"); sign; sign = take(reader, "+-")) {
    const next = product(reader);
    value = sign === "+" ? value + next : value - next;
  }
  return value;
}

function product(reader) {
  let value = signed(reader);
  for (let sign = take(reader, "*/"); sign; sign = take(reader, "*/")) {
    const next = signed(reader);
    value = sign === "*" ? value * next : value / next;
  }
  return value;
}

function signed(reader) {
  const sign = take(reader, "+-");
  if (!sign) return measured(reader);
  reader.depth += 1;
  return reader.depth > DEEPEST ? NaN : (sign === "-" ? -1 : 1) * signed(reader);
}

// A number, PI or a bracket, with its unit.
function measured(reader) {
  let value = atom(reader);
  for (let token = reader.tokens[reader.at]; token && token.word; token = reader.tokens[reader.at]) {
    const factor = isPi(token) ? Math.PI : FACTORS[token.word];
    if (factor === undefined) return NaN;
    value *= factor;
    reader.isBare = false;
    reader.at += 1;
  }
  return value;
}

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

const isPi = ({ word }) => word === "pi" || word === "π";

function take(reader, signs) {
  const token = reader.tokens[reader.at];
  if (!token || !token.sign || !signs.includes(token.sign)) return null;
  reader.at += 1;
  return token.sign;
}

// What values are read and shown in. `kind` is "angle", "length", or anything that has no unit here.
export class Units {
  constructor() {
    this.angle = "rad";
    this.listeners = [];
  }

  onChange(listener) { this.listeners.push(listener); }

  choose(angle) {
    this.angle = angle === "deg" ? "deg" : "rad";
    for (const listener of this.listeners) listener();
  }

  nameOf(kind) { return kind === "angle" ? this.angle : kind === "length" ? "m" : ""; }

  // The value in radians, metres or kilograms; null if the text is no value.
  read(text, kind) {
    const found = parseValue(text);
    if (!found) return null;
    return found.isBare && kind === "angle" && this.angle === "deg" ? found.value * DEGREE : found.value;
  }

  show(value, kind) {
    const isDegrees = kind === "angle" && this.angle === "deg";
    return format(isDegrees ? value / DEGREE : value, isDegrees ? 2 : 4);
  }
}
