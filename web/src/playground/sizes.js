// What a tab can do in which time: its server is some times slower than the same on a desktop, and has one thread.
const LARGE = 500_000; // characters, about 1,000 links: 7 s of a quiet processor
const MOST = 2_000_000; // characters, about 4,000 links; 3,000 took 21 s of a processor

/** @param {number} length */
const kilobytes = (length) => `${Math.round(length / 1000).toLocaleString("en")} kB`;

/**
 * What there is to say of a text of that many characters before it is opened; undefined for nothing.
 * @param {string} name
 * @param {number} length
 */
export function sizeProblem(name, length) {
  if (length <= LARGE) return undefined;
  const isRefused = length > MOST;
  const consequence = isRefused
    ? `too large for the playground, which takes ${kilobytes(MOST)}; use kdsl-lint and kindsl preview on your computer`
    : "large for a browser's tab: checking and drawing it can take a minute; kdsl-lint on your computer takes seconds";
  return { isRefused, sentence: `${name} has ${kilobytes(length)}, ${consequence}` };
}
