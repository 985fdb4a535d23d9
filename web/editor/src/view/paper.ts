/** The paper behind the cloth: the page's own, in light and in dark. */
import { parseColour, type Rgb } from "loomlight-fabric";

/** As style.css has it. */
export function paperHex(): string {
  return getComputedStyle(document.documentElement).getPropertyValue("--paper").trim();
}

/** Linear radiance. */
export function paperRadiance(): Rgb {
  return parseColour(paperHex(), "--paper");
}

/** Tells when the page turns light or dark, until the answer is called. */
export function watchPaper(onChange: () => void): () => void {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", onChange);
  return () => dark.removeEventListener("change", onChange);
}
