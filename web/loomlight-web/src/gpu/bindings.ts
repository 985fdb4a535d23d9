/**
 * Generated WGSL made to fit what browsers bind: at most 10 storage buffers a shader, where ours take up to 13.
 *
 * The record of the frame becomes a uniform, and the piece of each face lies behind the corners of all faces in one
 * buffer of four words a face; see `joinMeshes`. Shaders of networks read words of tables behind the packed numbers; see
 * `numbersAndWords`.
 */

const DECLARATION = /@binding\((\d+)\) @group\(0\) var(?:<[\w, ]+>)? (\w+?)_\d+ /g;

/** Binding numbers of a shader by the names of its globals. */
export function bindingsOf(wgsl: string): Record<string, number> {
  return Object.fromEntries([...wgsl.matchAll(DECLARATION)].map(([, binding, name]) => [name!, Number(binding)]));
}

/** The shader with fewer storage buffers. */
export function withFewerBuffers(wgsl: string): string {
  return withJoinedWords(withJoinedFaces(withUniformFrame(wgsl)));
}

/**
 * What shaders of networks bind as `packed_numbers`: the numbers, the words of all tables filled up to elements of four,
 * and an element that begins with the number of the first element of words.
 */
export function numbersAndWords(numbers: Uint32Array, words: Uint32Array): Uint32Array<ArrayBuffer> {
  const end = numbers.length + 4 * Math.ceil(words.length / 4);
  const joined = new Uint32Array(end + 4);
  joined.set(numbers);
  joined.set(words, numbers.length);
  joined[end] = numbers.length / 4;
  return joined;
}

function withUniformFrame(wgsl: string): string {
  const found = /var<storage, read> (frames_\d+) : array<(\w+)>/.exec(wgsl);
  if (found === null) return wgsl;
  const [declaration, name, record] = found as unknown as [string, string, string];
  const rest = wgsl.replace(declaration, `var<uniform> ${name} : ${record}`);
  return replaceIndexed(rest, name, () => name);
}

function withJoinedFaces(wgsl: string): string {
  const fabrics = /@binding\(\d+\) @group\(0\) var<storage, read> (face_fabrics_\d+) : array<u32>;/.exec(wgsl);
  const corners = /var<storage, read> (corners_\d+) : array<u32>/.exec(wgsl);
  if (fabrics === null || corners === null) return wgsl;
  const name = corners[1]!;
  return replaceIndexed(
    wgsl.replace(fabrics[0], ""),
    fabrics[1]!,
    (index) => `${name}[(arrayLength(&${name}) / 4u) * 3u + u32(${index})]`,
  );
}

function withJoinedWords(wgsl: string): string {
  const numbers = /var<storage, read> (packed_numbers_\d+) : array<vec4<u32>>/.exec(wgsl);
  const words = /@binding\(\d+\) @group\(0\) var<storage, read> (words_\d+) : array<u32>;/.exec(wgsl);
  if (numbers === null || words === null) return wgsl;
  const [all, table] = [numbers[1]!, words[1]!];
  const joined = (text: string): string => replaceIndexed(text, table, (index) => `joined_word(u32(${joined(index)}))`);
  const first = `${all}[arrayLength(&${all}) - 1u].x`;
  return `${joined(wgsl.replace(words[0], ""))}
fn joined_word(index : u32) -> u32 {
  return ${all}[${first} + (index >> 2u)][index & 3u];
}
`;
}

/** The text with every `name[index]` replaced; an index may hold brackets. */
function replaceIndexed(text: string, name: string, replacement: (index: string) => string): string {
  const pattern = new RegExp(`\\b${name}\\[`, "g");
  let result = "";
  let from = 0;
  for (let match = pattern.exec(text); match !== null; match = pattern.exec(text)) {
    let depth = 1;
    let end = pattern.lastIndex;
    for (; depth > 0; end++) depth += text[end] === "[" ? 1 : text[end] === "]" ? -1 : 0;
    result += text.slice(from, match.index) + replacement(text.slice(pattern.lastIndex, end - 1));
    from = pattern.lastIndex = end;
  }
  return result + text.slice(from);
}
