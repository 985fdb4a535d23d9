/** Gains by which light of a colour temperature becomes white; see `core/colour.py`. */
import { xyzToLinear, type Rgb } from "./colour.ts";

/** Light of this temperature is white as it is, kelvin. */
const UNCHANGED = 6500;
const DAYLIGHT_FROM = 4000;
/** Candlelight lies outside the gamut, where a channel would get no finite gain. */
const LEAST_LIGHT = 0.02;
const LUMINANCE: Rgb = [0.2126, 0.7152, 0.0722];

/** Gains of linear RGB under which light of a temperature, 1667 to 25000 K, is white; luminance is kept. */
export function whiteBalance(kelvin: number): Rgb {
  if (kelvin === UNCHANGED) return [1, 1, 1];
  const [x, y] = chromaticity(kelvin);
  const gains = xyzToLinear([x / y, 1, (1 - x - y) / y], "D65").map((light) => 1 / Math.max(light, LEAST_LIGHT)) as Rgb;
  const luminance = gains.reduce((sum, gain, channel) => sum + gain * LUMINANCE[channel]!, 0);
  return gains.map((gain) => gain / luminance) as Rgb;
}

/** CIE 1931 x, y: of daylight from 4000 K on (CIE 15:2018), of a black body below (Kim et al. 2002). */
function chromaticity(kelvin: number): [number, number] {
  const inverse = 1e3 / kelvin;
  if (kelvin < DAYLIGHT_FROM) {
    const x = polynomial(inverse, [-0.2661239, -0.2343589, 0.8776956, 0.17991]);
    const low = [-1.1063814, -1.3481102, 2.18555832, -0.20219683];
    const high = [-0.9549476, -1.37418593, 2.09137015, -0.16748867];
    return [x, polynomial(x, kelvin <= 2222 ? low : high)];
  }
  const x = polynomial(inverse, kelvin <= 7000 ? [-4.607, 2.9678, 0.09911, 0.244063] : [-2.0064, 1.9018, 0.24748, 0.23704]);
  return [x, polynomial(x, [-3, 2.87, -0.275])];
}

/** The value at x of a polynomial, its highest coefficient first. */
function polynomial(x: number, coefficients: readonly number[]): number {
  return coefficients.reduce((value, coefficient) => value * x + coefficient, 0);
}
