// A motion from a file: times, and where joints are at each. CSV with a header, or JSON.

/** @typedef {{ readonly name: string, readonly values: readonly number[] }} Track of a joint, radians or metres */
/** @typedef {{ readonly times: readonly number[], readonly tracks: readonly Track[], readonly strange: readonly string[] }} Trajectory seconds, ascending; `strange` names columns that are no joints */

const TIMES = ["time", "t", "time_s", "seconds"];

/**
 * Read a motion; a sentence where it is none.
 * @param {string} text
 * @param {ReadonlySet<string>} joints The robot's.
 * @returns {Trajectory | string}
 */
export function readTrajectory(text, joints) {
  const columns = /^\s*[[{]/.test(text) ? jsonColumns(text) : csvColumns(text);
  if (typeof columns === "string") return columns;
  const key = [...columns.keys()].find((name) => TIMES.includes(name.toLowerCase()));
  const times = key === undefined ? undefined : columns.get(key);
  if (!times) return "the file has no column 'time'";
  if (times.length < 2) return "the file has fewer than two samples";
  if (times.some((time, i) => !Number.isFinite(time) || (i > 0 && time <= times[i - 1]))) return "times are not numbers that increase";
  const tracks = [...columns].filter(([name]) => joints.has(name)).map(([name, values]) => ({ name, values }));
  if (!tracks.length) return "no column is named after a joint";
  const wrong = tracks.find(({ values }) => values.length !== times.length || !values.every(Number.isFinite));
  if (wrong) return `positions of joint '${wrong.name}' are not all numbers`;
  return { times, tracks, strange: [...columns.keys()].filter((name) => name !== key && !joints.has(name)) };
}

/** @param {string} text @returns {Map<string, number[]> | string} */
function csvColumns(text) {
  const lines = text.split(/\r?\n/).filter((line) => line.trim() && !line.startsWith("#"));
  const sign = [",", ";", "\t"].find((one) => lines[0]?.includes(one));
  if (!sign) return "the first line is not a list of columns";
  const cells = (/** @type {string} */ line) => line.split(sign).map((cell) => cell.trim().replace(/^"(.*)"$/, "$1"));
  const rows = lines.slice(1).map(cells), names = cells(lines[0]);
  return new Map(names.map((name, i) => [name, rows.map((row) => (row[i] ? Number(row[i]) : NaN))]));
}

/**
 * Columns `{"time": [...], "joint": [...]}`, those of joints maybe in `joints`; or rows `[{"time": 0, "joint": 0}, ...]`.
 * @param {string} text
 * @returns {Map<string, number[]> | string}
 */
function jsonColumns(text) {
  let told;
  try {
    told = JSON.parse(text);
  } catch (error) {
    return `the file is not JSON: ${/** @type {Error} */ (error).message}`;
  }
  if (Array.isArray(told)) {
    const rows = told.map((row) => flat(row)), names = new Set(rows.flatMap((row) => Object.keys(row)));
    return new Map([...names].map((name) => [name, rows.map((row) => Number(row[name] ?? NaN))]));
  }
  return new Map(Object.entries(flat(told)).filter(([, values]) => Array.isArray(values)).map(([name, values]) => [name, values.map(Number)]));
}

/** @param {any} row @returns {Record<string, any>} */
const flat = (row) => (row && typeof row === "object" ? { ...row, ...row.joints, ...row.q } : {});

/**
 * Where joints are at a time, between samples on a straight line.
 * @param {Trajectory} trajectory
 * @param {number} time
 */
export function poseAt({ times, tracks }, time) {
  const i = Math.max(1, Math.min(times.length - 1, firstAfter(times, time)));
  const share = Math.min(1, Math.max(0, (time - times[i - 1]) / (times[i] - times[i - 1])));
  return new Map(tracks.map(({ name, values }) => [name, values[i - 1] + share * (values[i] - values[i - 1])]));
}

/** @param {readonly number[]} times @param {number} time */
function firstAfter(times, time) {
  let low = 0, high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] > time) high = middle;
    else low = middle + 1;
  }
  return low;
}

/**
 * The rates of change of samples: those of the parabola through each and its neighbours.
 * @param {readonly number[]} times
 * @param {readonly number[]} values
 */
export function rates(times, values) {
  const slope = (/** @type {number} */ i) => (values[i + 1] - values[i]) / (times[i + 1] - times[i]), last = times.length - 1;
  return values.map((_, i) => {
    if (i === 0) return slope(0);
    if (i === last) return slope(last - 1);
    const before = times[i] - times[i - 1], after = times[i + 1] - times[i];
    return (slope(i - 1) * after + slope(i) * before) / (before + after);
  });
}
