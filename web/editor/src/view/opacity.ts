/** Pictures whose background is nothing. */
import { clamp, linearToSrgb } from "loomlight-fabric";
import type { Picture } from "loomlight-web";

import type { Pixels } from "./cloth_view.ts";

/** sRGB with the share of cloth as opacity: colours are those of the cloth alone, as PNG has it; `exposure` is in stops. */
export function withOpacity({ width, height, linear }: Pick<Picture, "width" | "height" | "linear">, exposure: number): Pixels {
  const gain = 2 ** exposure;
  const data = new Uint8ClampedArray(linear.length);
  for (let at = 0; at < linear.length; at += 4) {
    const share = clamp(linear[at + 3]!, 0, 1);
    if (share === 0) continue;
    for (let channel = 0; channel < 3; channel++)
      data[at + channel] = 255 * linearToSrgb(Math.min((gain * linear[at + channel]!) / share, 1));
    data[at + 3] = 255 * share;
  }
  return { width, height, data };
}
