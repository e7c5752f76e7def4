// Lengths and masses as people say them: 12 mm, 4 mg, 0.98 × 0.54 × 0.78 m.

/** @typedef {readonly (readonly [factor: number, name: string, least: number])[]} Scale from `least` on a unit is used, in itself */

/** @type {Readonly<Record<"m" | "kg", Scale>>} */
const SCALES = {
  m: [[1e3, "km", 10], [1, "m", 0.1], [1e-3, "mm", 0.1], [1e-6, "µm", 0]],
  kg: [[1e3, "t", 10], [1, "kg", 0.1], [1e-3, "g", 0.1], [1e-6, "mg", 0.1], [1e-9, "µg", 0]],
};

/**
 * Numbers in one unit that suits the largest.
 * @param {readonly number[]} values Metres or kilograms.
 * @param {"m" | "kg"} unit
 * @param {number} [digits] That count.
 */
export function inUnit(values, unit, digits = 3) {
  const largest = Math.max(...values.map(Math.abs)), scale = SCALES[unit];
  const found = scale.find(([factor, , least]) => largest >= least * factor), [factor, name] = (largest > 0 && found) || [1, unit];
  const texts = values.map((value) => String(Number((value / factor).toPrecision(digits))));
  return `${texts.join(" × ")} ${name}`;
}

/**
 * The least of 1, 2, 5, 10, 20, ... that is not less.
 * @param {number} length
 */
export function roundUp(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return power * ([1, 2, 5].find((step) => step * power >= length * (1 - 1e-9)) ?? 10);
}

/**
 * What a slider can stand at from one number to another: round numbers, of which its ends are the next beyond.
 * @param {number} minimum
 * @param {number} maximum
 * @param {number} most So many stops at most.
 */
export function stopsOf(minimum, maximum, most) {
  const step = roundUp((maximum - minimum) / (most - 2)), round = (/** @type {number} */ value) => Number(value.toPrecision(12));
  return { min: round(step * Math.floor(minimum / step + 1e-9)), max: round(step * Math.ceil(maximum / step - 1e-9)), step: round(step) };
}
