// Files that were dropped, kept by the browser: a studio that was started again is given them again.

interface Kept {
  key: string;
  /** The call that takes the file. */
  path: string;
  file: Blob;
  at: number;
}

/** Files and bytes that are kept, and for how long [ms]; the ones used longest ago leave first. */
const MOST_FILES = 24;
const MOST_BYTES = 256 * 2 ** 20;
const LONGEST = 30 * 86_400_000;

let opening: Promise<IDBDatabase> | null = null;

function base(): Promise<IDBDatabase> {
  opening ??= new Promise((done, wrong) => {
    const asked = indexedDB.open("clerestory", 1);
    asked.onupgradeneeded = () => asked.result.createObjectStore("files", { keyPath: "key" }).createIndex("at", "at");
    asked.onsuccess = () => done(asked.result);
    asked.onerror = () => wrong(asked.error);
  });
  return opening;
}

function ended<T>(asked: IDBRequest<T>): Promise<T> {
  return new Promise((done, wrong) => {
    asked.onsuccess = () => done(asked.result);
    asked.onerror = () => wrong(asked.error);
  });
}

/** Keeps a file under the key that the studio gave it. Where the browser keeps nothing, nothing is kept. */
export async function keepFile(key: string, path: string, file: Blob): Promise<void> {
  try {
    const files = (await base()).transaction("files", "readwrite").objectStore("files");
    await ended(files.put({ key, path, file, at: Date.now() } satisfies Kept));
    let [count, bytes] = [0, 0];
    const looking = files.index("at").openCursor(null, "prev");
    looking.onsuccess = () => {
      const here = looking.result;
      if (!here) return;
      const one = here.value as Kept;
      const isOver = count > 0 && (count >= MOST_FILES || bytes + one.file.size > MOST_BYTES || one.at < Date.now() - LONGEST);
      if (isOver) here.delete();
      else [count, bytes] = [count + 1, bytes + one.file.size];
      here.continue();
    };
  } catch {
    // a private window, or no room: the file is dropped again by hand
  }
}

/** The file of a key, and the call that takes it. */
export async function keptFile(key: string): Promise<{ path: string; file: Blob } | null> {
  try {
    const files = (await base()).transaction("files", "readwrite").objectStore("files");
    const found = (await ended(files.get(key))) as Kept | undefined;
    if (found) files.put({ ...found, at: Date.now() });
    return found ?? null;
  } catch {
    return null;
  }
}
