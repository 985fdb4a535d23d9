/** Objects in JSON of which nothing is known. */
export type Table = Readonly<Record<string, unknown>>;

export function isTable(json: unknown): json is Table {
  return typeof json === "object" && json !== null && !Array.isArray(json);
}

/** A JSON object; one without entries in place of any other value. */
export function tableOf(json: unknown): Table {
  return isTable(json) ? json : {};
}
