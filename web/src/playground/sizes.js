// What a tab can do in which time: its server is some times slower than the same on a desktop, and has one thread.
const LARGE = 250_000; // characters, about 500 links
const MOST = 2_000_000; // characters, about 4,000 links: minutes in a tab

const kilobytes = (length) => `${Math.round(length / 1000).toLocaleString("en")} kB`;

/** What there is to say of a text of that many characters before it is opened; undefined for nothing. */
export function sizeProblem(name, length) {
  if (length <= LARGE) return undefined;
  const isRefused = length > MOST;
  const consequence = isRefused
    ? `too large for the playground, which takes ${kilobytes(MOST)}; use kdsl-lint and kindsl preview on your computer`
    : "large for a browser's tab: checking and drawing it can take minutes; kdsl-lint on your computer takes seconds";
  return { isRefused, sentence: `${name} has ${kilobytes(length)}, ${consequence}` };
}
