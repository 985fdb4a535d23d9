/** Tables of the light on fabrics, which the browser keeps in a database for the next visit: the latest few. */
import type { TableCache } from "loomlight-web";

const DATABASE = "loomlight";
const TABLES = "tables";
const MAX = 24;
/** Of one fabric's tables, bytes: larger ones are made anew. */
const MAX_BYTES = 32 << 20;

interface Entry {
  readonly key: string;
  readonly words: Uint32Array<ArrayBuffer>;
  /** When it was used last, milliseconds. */
  readonly used: number;
}

/** The browser's store of tables; it keeps nothing where the browser does not. */
export const tableStore: TableCache = {
  async get(key) {
    try {
      const database = await opened();
      const store = database.transaction(TABLES, "readwrite").objectStore(TABLES);
      const entry = (await answer(store.get(key))) as Entry | undefined;
      if (!(entry?.words instanceof Uint32Array)) return null;
      store.put({ ...entry, used: Date.now() });
      return entry.words;
    } catch {
      return null;
    }
  },
  put(key, words) {
    if (words.byteLength > MAX_BYTES) return;
    void (async () => {
      try {
        const database = await opened();
        const store = database.transaction(TABLES, "readwrite").objectStore(TABLES);
        await answer(store.put({ key, words, used: Date.now() } satisfies Entry));
        const keys = (await answer(store.index("used").getAllKeys())) as IDBValidKey[];
        for (const old of keys.slice(0, Math.max(0, keys.length - MAX))) store.delete(old);
      } catch {
        // A browser that keeps nothing is no fault of the user's.
      }
    })();
  },
};

let opening: Promise<IDBDatabase> | null = null;

function opened(): Promise<IDBDatabase> {
  opening ??= new Promise((resolve, reject) => {
    const request = indexedDB.open(DATABASE, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(TABLES, { keyPath: "key" }).createIndex("used", "used");
    request.onsuccess = () => resolve(request.result);
    request.onerror = request.onblocked = () => reject(request.error ?? new Error("The database is held by another page."));
  });
  return opening;
}

function answer<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("The database failed."));
  });
}
