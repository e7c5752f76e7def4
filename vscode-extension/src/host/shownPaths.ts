// Which paths of the disk Python may see: folders as wholes, and what decides for the documents in them.
import * as path from "node:path";

const CONFIGURATIONS = new Set(["kindsl.toml", "pyproject.toml"]);

export class ShownPaths {
  readonly #folders = new Set<string>();
  /** Folders of which only the files are shown: those of documents that are in no folder. */
  readonly #besides = new Set<string>();

  addFolder(folder: string): void {
    this.#folders.add(folder);
  }

  removeFolder(folder: string): void {
    this.#folders.delete(folder);
  }

  /** Show the files of a folder, unless it is shown anyway. */
  addBeside(folder: string): void {
    if (!this.#isInFolder(folder)) this.#besides.add(folder);
  }

  /** Whether a path is shown; `isFolder` says what is there. */
  shows(place: string, isFolder: boolean): boolean {
    if (this.#isInFolder(place)) return true;
    if (isFolder) return this.leadsTo(place);
    const above = path.posix.dirname(place);
    return this.#besides.has(above) || (CONFIGURATIONS.has(path.posix.basename(place)) && this.leadsTo(above));
  }

  /** Whether a path is a folder that was opened, or is on the way to one. */
  leadsTo(place: string): boolean {
    return [...this.#folders, ...this.#besides].some((folder) => isWithin(folder, place));
  }

  #isInFolder(place: string): boolean {
    return [...this.#folders].some((folder) => isWithin(place, folder));
  }
}

function isWithin(place: string, folder: string): boolean {
  return place === folder || place.startsWith(`${folder}/`);
}
