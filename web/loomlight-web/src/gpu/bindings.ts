/** Where generated WGSL binds its buffers. */

const DECLARATION = /@binding\((\d+)\) @group\(0\) var(?:<[\w, ]+>)? (\w+?)_\d+ /g;

/** Binding numbers of a shader by the names of its globals. */
export function bindingsOf(wgsl: string): Record<string, number> {
  return Object.fromEntries([...wgsl.matchAll(DECLARATION)].map(([, binding, name]) => [name!, Number(binding)]));
}
