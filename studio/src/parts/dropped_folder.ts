// What was dropped as one file: a folder, such as a results.zarr, as a ZIP archive of it.

import { Refused } from "../server/ask";
import { words } from "../words/page";

/** Files of a folder at most, and bytes of them all. */
const MOST_FILES = 10_000;
const MOST_BYTES = 64 * 2 ** 20;

/** The file that was dropped, or the folder. To be called while the event lasts. */
export function droppedFile(data: DataTransfer | null): Promise<File | undefined> {
  const entry = data?.items[0]?.webkitGetAsEntry?.();
  const file = data?.files[0];
  return entry?.isDirectory ? zipped(entry as FileSystemDirectoryEntry) : Promise.resolve(file);
}

interface Part {
  name: Uint8Array<ArrayBuffer>;
  bytes: Uint8Array<ArrayBuffer>;
}

/** A folder as an archive whose files are not packed: chunks of a store are already. */
async function zipped(folder: FileSystemDirectoryEntry): Promise<File> {
  const parts: Part[] = [];
  const wait: [FileSystemEntry, string][] = [[folder, ""]];
  let size = 0;
  for (let next = wait.pop(); next; next = wait.pop()) {
    const [entry, path] = next;
    if (entry.isDirectory) {
      for (const one of await entriesOf(entry as FileSystemDirectoryEntry)) wait.push([one, `${path}${entry.name}/`]);
    } else {
      const file = await new Promise<File>((done, wrong) => (entry as FileSystemFileEntry).file(done, wrong));
      size += file.size;
      if (parts.length >= MOST_FILES || size > MOST_BYTES) throw new Refused([{ field: null, message: words.folderTooLarge(folder.name) }]);
      parts.push({ name: new TextEncoder().encode(path + entry.name), bytes: new Uint8Array(await file.arrayBuffer()) });
    }
  }
  return new File(archive(parts), `${folder.name}.zip`, { type: "application/zip" });
}

/** All entries of a folder, which come a hundred at a time. */
async function entriesOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((done, wrong) => reader.readEntries(done, wrong));
    if (!some.length) return all;
    all.push(...some);
  }
}

/** Local headers with their files, the directory of them, and its end (APPNOTE 4.3). */
function archive(parts: Part[]): BlobPart[] {
  const files: BlobPart[] = [];
  const directory: BlobPart[] = [];
  let at = 0;
  let directorySize = 0;
  for (const { name, bytes } of parts) {
    // version 2.0, names in UTF-8, stored, 1 January 1980, checksum, sizes, length of the name
    const common = [[2, 20], [2, 0x0800], [2, 0], [2, 0], [2, 0x21], [4, crc32(bytes)], [4, bytes.length], [4, bytes.length], [2, name.length], [2, 0]];
    const local = numbers([[4, 0x04034b50], ...common]);
    const central = numbers([[4, 0x02014b50], [2, 20], ...common, [2, 0], [2, 0], [2, 0], [4, 0], [4, at]]);
    files.push(local, name, bytes);
    directory.push(central, name);
    at += local.length + name.length + bytes.length;
    directorySize += central.length + name.length;
  }
  const count = parts.length;
  return [...files, ...directory, numbers([[4, 0x06054b50], [2, 0], [2, 0], [2, count], [2, count], [4, directorySize], [4, at], [2, 0]])];
}

/** Numbers of so many bytes each, the lowest first. */
function numbers(all: number[][]): Uint8Array<ArrayBuffer> {
  return new Uint8Array(all.flatMap(([bytes, value]) => Array.from({ length: bytes }, (_, k) => (value >>> (8 * k)) & 0xff)));
}

const TABLE = Array.from({ length: 256 }, (_, at) => {
  let value = at;
  for (let bit = 0; bit < 8; bit++) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
  return value >>> 0;
});

function crc32(bytes: Uint8Array): number {
  let value = 0xffffffff;
  for (const byte of bytes) value = TABLE[(value ^ byte) & 0xff] ^ (value >>> 8);
  return (value ^ 0xffffffff) >>> 0;
}
