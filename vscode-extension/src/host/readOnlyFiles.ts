// A file system for Python that shows parts of the disk at their own paths and writes nothing.
//
// Links stay links, which Python follows within what is shown: one that leads out leads nowhere.
import * as fs from "node:fs";
import * as path from "node:path";
import type { FsNode, FsStream, Pyodide } from "./pyodide";
import { ShownPaths } from "./shownPaths";

const { O_NOFOLLOW = 0, O_NONBLOCK = 0, O_RDONLY } = fs.constants;
const WRITABLE_BITS = 0o222;
/** Of open(2) as Emscripten has it: O_WRONLY and O_RDWR, O_CREAT, O_TRUNC, O_APPEND. */
const WRITING_FLAGS = 0o3 | 0o100 | 0o1000 | 0o2000;
const BLOCK_BYTES = 4096;
const SEEK_CURRENT = 1, SEEK_END = 2;

export class ReadOnlyFiles {
  readonly #shown = new ShownPaths();
  readonly #mounted: string[] = [];

  constructor(private readonly py: Pyodide) {}

  /** Show a folder of the editor (`/c:/work` is `c:\work` on Windows) and the configuration above it. */
  addFolder(folder: string): void {
    if (this.#mount(folder)) this.#shown.addFolder(folder);
  }

  removeFolder(folder: string): void {
    this.#shown.removeFolder(folder);
  }

  /** Show the files beside a document that is in none of the folders. */
  addDocument(document: string): void {
    const folder = path.posix.dirname(document);
    if (this.#mount(folder)) this.#shown.addBeside(folder);
  }

  /** Mount the topmost folder of a path that Python has not itself; return whether the path can be shown. */
  #mount(folder: string): boolean {
    const { FS } = this.py;
    if (this.#mounted.some((point) => `${folder}/`.startsWith(`${point}/`))) return true;
    if (FS.analyzePath(folder).exists && FS.readdir(folder).length > 2) return false;
    let point = folder;
    for (let above = path.posix.dirname(point); !FS.analyzePath(above).exists; above = path.posix.dirname(above)) point = above;
    FS.mkdirTree(point);
    FS.mount(this.#type(point), {}, point);
    this.#mounted.push(point);
    return true;
  }

  #type(point: string): object {
    const { FS } = this.py;
    const operations = { node: this.#nodeOperations(), stream: this.#streamOperations() };
    const create = (parent: FsNode | null, name: string, mode: number): FsNode => {
      const node = FS.createNode(parent, name, mode, 0);
      // Not kept: what has that name a moment later may be something else.
      if (parent !== null) FS.hashRemoveNode(node);
      return Object.assign(node, { node_ops: operations.node, stream_ops: operations.stream });
    };
    const lookup = (parent: FsNode, name: string) => {
      const place = path.posix.join(FS.getPath(parent), name);
      return create(parent, name, this.#stat(place).mode);
    };
    Object.assign(operations.node, { lookup });
    return { mount: () => create(null, "/", this.#statOnDisk(point, true).mode & ~WRITABLE_BITS) };
  }

  #nodeOperations(): object {
    const { FS } = this.py;
    const refuse = (): never => this.#fail("EROFS");
    const getattr = (node: FsNode) => {
      const { dev, ino, mode, nlink, uid, gid, rdev, size, atime, mtime, ctime } = this.#stat(FS.getPath(node));
      const blocks = Math.ceil(size / BLOCK_BYTES);
      return { dev, ino, mode, nlink, uid, gid, rdev, size, atime, mtime, ctime, blksize: BLOCK_BYTES, blocks };
    };
    return {
      getattr,
      readdir: (node: FsNode) => [".", "..", ...this.#list(FS.getPath(node))],
      readlink: (node: FsNode) => virtual(this.#told(() => fs.readlinkSync(onDisk(FS.getPath(node))))),
      ...Object.fromEntries(["setattr", "mknod", "rename", "unlink", "rmdir", "symlink"].map((name) => [name, refuse])),
    };
  }

  #streamOperations(): object {
    return {
      open: (stream: FsStream) => {
        if (this.py.FS.isDir(stream.node.mode)) return;
        try {
          if (stream.flags & WRITING_FLAGS) this.#fail("EROFS");
          const file = onDisk(this.py.FS.getPath(stream.node));
          stream.descriptor = this.#told(() => fs.openSync(file, O_RDONLY | O_NOFOLLOW | O_NONBLOCK));
        } catch (error) {
          this.py.FS.closeStream(stream.fd);
          throw error;
        }
      },
      close: ({ descriptor }: FsStream) => {
        if (descriptor !== undefined) this.#told(() => fs.closeSync(descriptor));
      },
      read: ({ descriptor }: FsStream, buffer: Uint8Array, offset: number, length: number, position: number) =>
        this.#told(() => fs.readSync(descriptor ?? -1, new Uint8Array(buffer.buffer, buffer.byteOffset + offset, length), 0, length, position)),
      write: () => this.#fail("EROFS"),
      llseek: (stream: FsStream, offset: number, from: number) => {
        const { position, descriptor } = stream;
        const end = () => this.#told(() => fs.fstatSync(descriptor ?? -1).size);
        const place = offset + (from === SEEK_CURRENT ? position : from === SEEK_END ? end() : 0);
        return place < 0 ? this.#fail("EINVAL") : place;
      },
    };
  }

  /** What is at a path that is shown, without leave to write. */
  #stat(place: string): fs.Stats {
    const stat = this.#statOnDisk(place, this.#shown.leadsTo(place));
    const isKnown = stat.isDirectory() || stat.isFile() || stat.isSymbolicLink();
    if (!isKnown || !this.#shown.shows(place, stat.isDirectory())) this.#fail("ENOENT");
    stat.mode &= ~WRITABLE_BITS;
    return stat;
  }

  /** What is at a path; a folder that was opened by way of links is what they lead to. */
  #statOnDisk(place: string, isFollowed: boolean): fs.Stats {
    return this.#told(() => (isFollowed ? fs.statSync : fs.lstatSync)(onDisk(place)));
  }

  #list(folder: string): string[] {
    const entries = this.#told(() => fs.readdirSync(onDisk(folder), { withFileTypes: true }));
    const isShown = (entry: fs.Dirent) => {
      const place = path.posix.join(folder, entry.name);
      return this.#shown.shows(place, entry.isDirectory() || this.#shown.leadsTo(place));
    };
    return entries.filter(isShown).map(({ name }) => name);
  }

  /** Do what may fail, and tell Python its error. */
  #told<Value>(work: () => Value): Value {
    try {
      return work();
    } catch (error) {
      return this.#fail((error as NodeJS.ErrnoException).code ?? "EIO");
    }
  }

  #fail(code: string): never {
    const { ERRNO_CODES, FS } = this.py;
    throw new FS.ErrnoError(ERRNO_CODES[code] ?? ERRNO_CODES["EIO"] ?? 29);
  }
}

/** The path of an address of the editor; undefined for one of another machine, or that is no file's. */
export function placeOf(uri: string): string | undefined {
  if (!uri.startsWith("file:///")) return undefined;
  const place = decodeURIComponent(new URL(uri).pathname);
  return place.length > 1 ? place.replace(/\/$/, "") : undefined;
}

/** A path of this machine as Python sees it. */
export function virtual(place: string): string {
  if (process.platform !== "win32") return place;
  const slashed = place.replaceAll("\\", "/");
  return /^[a-z]:/i.test(slashed) ? `/${slashed[0]?.toLowerCase()}${slashed.slice(1)}` : slashed;
}

function onDisk(place: string): string {
  return process.platform === "win32" ? place.slice(1) : place;
}
