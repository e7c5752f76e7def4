// The licences of what others wrote, as one text.
import { readFile, readdir } from "node:fs/promises";
import path from "node:path";

const LICENCE = /^(licen[cs]e|copying|notice)/i;

/** One text for parts `{ name, version, licence, text }`; each is named once. */
export function notices(parts) {
  const byName = new Map(parts.map((part) => [`${part.name} ${part.version}`, part]));
  const sections = [...byName].sort(([a], [b]) => a.localeCompare(b)).map(([title, { licence, text }]) =>
    [title, ...(licence ? [`Licence: ${licence}`] : []), "", text.trim()].join("\n"));
  const first = "This package contains the following works of others, each under its own licence.";
  return [first, ...sections].join(`\n\n${"-".repeat(80)}\n\n`) + "\n";
}

/** The Python packages that pip has put into a folder. */
export async function pythonParts(folder) {
  const infos = (await readdir(folder)).filter((name) => name.endsWith(".dist-info"));
  return Promise.all(infos.map(async (info) => {
    const metadata = await readFile(path.join(folder, info, "METADATA"), "utf8");
    const value = (key) => new RegExp(`^${key}: (.+)$`, "m").exec(metadata)?.[1];
    const licence = value("License-Expression") ?? value("License");
    return { name: value("Name"), version: value("Version"), licence, text: await licenceIn(path.join(folder, info)) };
  }));
}

/** What meshcat's viewer is put together from; it says so itself. */
export async function viewerParts(file) {
  return JSON.parse(await readFile(file, "utf8")).map(({ name, version, license, licenseText }) =>
    ({ name, version, licence: license, text: licenseText ?? "" }));
}

/** The npm packages that went into a bundle of esbuild, by its metafile. */
export async function nodeParts(metafile, root) {
  const names = Object.keys(metafile.inputs).map((input) => /.*node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(input)?.[0]);
  return Promise.all([...new Set(names.filter(Boolean))].map((folder) => nodePart(path.join(root, folder))));
}

/** One npm package; one that carries no licence file is given its text. */
export async function nodePart(folder, text = undefined) {
  const { name, version, license } = JSON.parse(await readFile(path.join(folder, "package.json"), "utf8"));
  return { name, version, licence: license, text: text ?? (await licenceIn(folder)) };
}

async function licenceIn(folder) {
  const names = await readdir(folder, { recursive: true });
  const own = names.filter((name) => LICENCE.test(path.basename(name)) && !name.includes("node_modules"));
  const files = own.filter((name) => !/\.(js|py|json)$/.test(name) && path.dirname(name).split(path.sep).length <= 1);
  const texts = await Promise.all(files.sort().map((name) => readFile(path.join(folder, name), "utf8").catch(() => "")));
  if (texts.join("").trim() === "") throw new Error(`${folder} has no licence to quote`);
  return texts.join("\n\n");
}
