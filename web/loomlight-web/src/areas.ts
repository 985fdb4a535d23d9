/** Rectangles of a picture that are drawn one after the other, the middle first. */

/** Pixels, from the picture's upper left corner. */
export interface Area {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export const pixelsOf = ({ width, height }: Area): number => width * height;

/** Areas of at most so many pixels that together are a picture of this size, by their distance from its middle. */
export function areasOf(width: number, height: number, pixels: number): Area[] {
  const side = Math.max(1, Math.floor(Math.sqrt(pixels)));
  const [columns, rows] = [Math.ceil(width / side), Math.ceil(height / side)];
  const edges = (count: number, length: number): number[] =>
    Array.from({ length: count + 1 }, (_, number) => Math.round((number * length) / count));
  const [lefts, tops] = [edges(columns, width), edges(rows, height)];
  const areas: Area[] = [];
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const [x, y] = [lefts[column]!, tops[row]!];
      areas.push({ x, y, width: lefts[column + 1]! - x, height: tops[row + 1]! - y });
    }
  const away = (area: Area): number =>
    Math.hypot(area.x + area.width / 2 - width / 2, area.y + area.height / 2 - height / 2);
  return areas.sort((one, other) => away(one) - away(other));
}

/**
 * Takes the next areas from a list: as many as are at most so many pixels, or where the first is larger a part of it,
 * whose rest stays.
 */
export function taken(areas: Area[], pixels: number): Area[] {
  const result: Area[] = [];
  let left = pixels;
  while (areas.length > 0 && (result.length === 0 || pixelsOf(areas[0]!) <= left)) {
    let next = areas.shift()!;
    while (pixelsOf(next) > Math.max(left, 1) && result.length === 0 && pixelsOf(next) > 1) {
      const [half, rest] = halves(next);
      areas.unshift(rest);
      next = half;
    }
    result.push(next);
    left -= pixelsOf(next);
  }
  return result;
}

function halves({ x, y, width, height }: Area): readonly [Area, Area] {
  if (width >= height) {
    const first = Math.ceil(width / 2);
    return [{ x, y, width: first, height }, { x: x + first, y, width: width - first, height }];
  }
  const first = Math.ceil(height / 2);
  return [{ x, y, width, height: first }, { x, y: y + first, width, height: height - first }];
}
