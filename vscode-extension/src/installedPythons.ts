// Pythons that are installed where tools put them, though the plain names mean another one or none.
import * as path from "node:path";
import type { Command } from "./python";

const NEWEST_MINOR = 14, OLDEST_MINOR = 11;
/** Folders below the user's own in which each folder is a Python, or an environment with one. */
const OF_USER = [".pyenv/versions", ".local/share/uv/python", "Library/Application Support/uv/python"];
const CONDA = ["miniconda3", "anaconda3", "miniforge3", "mambaforge"];
const OF_SYSTEM = ["/usr/bin", "/usr/local/bin", "/opt/homebrew/bin"];
const VERSIONED = /^python3\.\d+$/;

export interface Disk {
  readonly home: string;
  /** The environment's variables. */
  readonly env: Readonly<Record<string, string | undefined>>;
  /** The names in a folder; none where there is no such folder. */
  readonly list: (folder: string) => Promise<readonly string[]>;
}

/** The commands to try, the newest versions first; on Windows the launcher `py` knows them all. */
export async function installedPythons(disk: Disk, platform: NodeJS.Platform): Promise<Command[]> {
  if (platform === "win32") return [];
  const named = Array.from({ length: NEWEST_MINOR - OLDEST_MINOR + 1 }, (_, i) => `python3.${NEWEST_MINOR - i}`);
  const environments = [disk.env["CONDA_PREFIX"], disk.env["VIRTUAL_ENV"]].filter((folder) => folder !== undefined);
  for (const folder of OF_USER) environments.push(...(await below(disk, path.join(disk.home, folder))));
  for (const name of CONDA) {
    const conda = path.join(disk.home, name);
    environments.push(...((await disk.list(conda)).length > 0 ? [conda] : []), ...(await below(disk, path.join(conda, "envs"))));
  }
  const systems = await Promise.all(OF_SYSTEM.map((folder) => versioned(disk, folder)));
  const found = [...named, ...environments.map((folder) => path.join(folder, "bin", "python3")), ...systems.flat()];
  return [...new Set(found)].map((program): Command => [program]);
}

async function below(disk: Disk, folder: string): Promise<string[]> {
  const names = await disk.list(folder);
  return [...names].sort(newestFirst).map((name) => path.join(folder, name));
}

async function versioned(disk: Disk, folder: string): Promise<string[]> {
  const names = (await disk.list(folder)).filter((name) => VERSIONED.test(name));
  return names.sort(newestFirst).map((name) => path.join(folder, name));
}

function newestFirst(one: string, other: string): number {
  return other.localeCompare(one, "en", { numeric: true });
}
