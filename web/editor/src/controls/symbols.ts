/** What each slider is called by a weaver, what the equations call it, and its range. */
import {
  DIFFUSE_BLEND,
  GAP,
  HEIGHT_SCALE,
  IRREGULARITY,
  IRREGULARITY_FIELDS,
  OPTICAL_DEPTH,
  ROUGHNESS,
  SPECULAR,
  TRANSLUCENCY,
  type FamilyName,
} from "loomlight-fabric";

/** What the page calls the families of threads. */
export const FAMILY_NAMES: Readonly<Record<FamilyName, string>> = { warp: "Warp", weft: "Weft" };

export interface Quantity {
  /** A weaver's word. */
  readonly label: string;
  /** The symbol in the equations and what it is, for the tooltip. */
  readonly tip: string;
  readonly low: number;
  readonly high: number;
  readonly step: number;
  readonly unit?: string;
  /** Words at the two ends of the slider. */
  readonly ends?: readonly [string, string];
  /** Used where neither the fabric nor the weave says otherwise. */
  readonly standard: number;
}

/** Of one family of yarns, by the field's name. */
export const YARN_QUANTITIES: Readonly<Record<string, Quantity>> = {
  specular: {
    label: "Lustre",
    tip: "kₛ: strength of the fibres' highlight",
    low: 0,
    high: 1,
    step: 0.01,
    ends: ["dull", "bright"],
    standard: SPECULAR,
  },
  roughness: {
    label: "Fibre spread",
    tip: "α: spread of the fibres' directions (roughness)",
    low: 0.01,
    high: 1,
    step: 0.01,
    ends: ["silk", "wool"],
    standard: ROUGHNESS,
  },
  specular_grazing: {
    label: "Rise towards the edge",
    tip: "What the highlight gains where the cloth is seen or lit flat; warp and weft share the mean (specular_grazing)",
    low: 0,
    high: 4,
    step: 0.05,
    ends: ["level", "strong"],
    standard: 0,
  },
  height_scale: {
    label: "Relief",
    tip: "β: multiplies the heights of the yarns",
    low: 0.01,
    high: 2,
    step: 0.01,
    ends: ["pressed", "raised"],
    standard: HEIGHT_SCALE,
  },
  inclination_deg: {
    label: "Crimp",
    tip: "U: slope of a float's ends, degrees",
    low: 0,
    high: 80,
    step: 1,
    unit: "°",
    ends: ["lies straight", "dives"],
    standard: 24,
  },
  twist_deg: {
    label: "Twist",
    tip: "ψ: angle of the fibres to the yarn; negative is Z",
    low: -89,
    high: 89,
    step: 1,
    unit: "°",
    ends: ["Z", "S"],
    standard: 0,
  },
  plies: {
    label: "Plies",
    tip: "Yarns that are twisted together",
    low: 1,
    high: 12,
    step: 1,
    standard: 1,
  },
  ply_twist_deg: {
    label: "Twist of the plies",
    tip: "Angle of the plies to the yarn; negative is Z",
    low: -60,
    high: 60,
    step: 1,
    unit: "°",
    ends: ["Z", "S"],
    standard: 0,
  },
  fibre_tilt_deg: {
    label: "Stray fibres",
    tip: "Tilt of single fibres out of the yarn's twist, degrees",
    low: 0,
    high: 30,
    step: 0.5,
    unit: "°",
    ends: ["combed", "carded"],
    standard: 0,
  },
  slub: {
    label: "Slubs, near",
    tip: "Thick and thin places of a few widths, seen close up: the shortest waves of uneven mass (slub)",
    low: 0,
    high: 1,
    step: 0.01,
    ends: ["even", "uneven"],
    standard: 0,
  },
  hairiness: {
    label: "Hairiness",
    tip: "Fibres that stand off the yarn",
    low: 0,
    high: 1,
    step: 0.01,
    ends: ["clean", "hairy"],
    standard: 0,
  },
  mass_cv: {
    label: "Uneven mass",
    tip: "Coefficient of variation of the mass of 8 mm of yarn, Uster's CVm (mass_cv)",
    low: 0,
    high: 0.6,
    step: 0.01,
    ends: ["filament", "hand-spun"],
    standard: IRREGULARITY_FIELDS.mass_cv.standard,
  },
  fibre_length_mm: {
    label: "Length of the fibres",
    tip: "Staple: thick and thin places are two to three times as long (fibre_length_mm)",
    low: 5,
    high: 2000,
    step: 1,
    unit: " mm",
    standard: IRREGULARITY_FIELDS.fibre_length_mm.standard,
  },
  thick_places: {
    label: "Thick places",
    tip: "Per metre of yarn (thick_places)",
    low: 0,
    high: 200,
    step: 0.5,
    unit: " /m",
    standard: IRREGULARITY_FIELDS.thick_places.standard,
  },
  thick_length_mm: {
    label: "Length of a thick place",
    tip: "Half of to one and a half times that by chance (thick_length_mm)",
    low: 2,
    high: 1000,
    step: 1,
    unit: " mm",
    standard: IRREGULARITY_FIELDS.thick_length_mm.standard,
  },
  thick_size: {
    label: "Size of a thick place",
    tip: "How much more mass it has in its middle: 1 is twice the mean (thick_size)",
    low: 0,
    high: 5,
    step: 0.05,
    standard: IRREGULARITY_FIELDS.thick_size.standard,
  },
  shade: {
    label: "Streaks",
    tip: "Deviation of the depth of shade along the yarn: rope-dyed, hand-dyed, undyed flax (shade)",
    low: 0,
    high: 1,
    step: 0.01,
    ends: ["level", "streaky"],
    standard: IRREGULARITY_FIELDS.shade.standard,
  },
  melange: {
    label: "Mélange",
    tip: "The same within millimetres: fibres of several colours mixed (melange)",
    low: 0,
    high: 1,
    step: 0.01,
    ends: ["solid", "heather"],
    standard: IRREGULARITY_FIELDS.melange.standard,
  },
  neps: {
    label: "Neps",
    tip: "Small knots of fibres of another colour, per metre of yarn (neps)",
    low: 0,
    high: 200,
    step: 0.5,
    unit: " /m",
    standard: IRREGULARITY_FIELDS.neps.standard,
  },
  nep_length_mm: {
    label: "Length of a nep",
    tip: "Half of to one and a half times that by chance (nep_length_mm)",
    low: 1,
    high: 30,
    step: 0.5,
    unit: " mm",
    standard: IRREGULARITY_FIELDS.nep_length_mm.standard,
  },
  gap: {
    label: "Openness",
    tip: "Gap: share of a thread's spacing that stays open",
    low: 0,
    high: 0.95,
    step: 0.01,
    ends: ["closed", "sheer"],
    standard: GAP,
  },
  translucency: {
    label: "Translucency",
    tip: "Share of the scattered light that passes through",
    low: 0,
    high: 1,
    step: 0.01,
    ends: ["opaque", "glows"],
    standard: TRANSLUCENCY,
  },
};

/** Of the whole cloth, by the field's dotted name. */
export const CLOTH_QUANTITIES: Readonly<Record<string, Quantity>> = {
  ends_per_cm: {
    label: "Ends per cm",
    tip: "Sett: warp threads per centimetre",
    low: 1,
    high: 150,
    step: 0.5,
    standard: 20,
  },
  picks_per_cm: {
    label: "Picks per cm",
    tip: "Weft threads per centimetre",
    low: 1,
    high: 150,
    step: 0.5,
    standard: 20,
  },
  "sheen.strength": {
    label: "Nap",
    tip: "Sheen: fly-away fibres that catch light at the edge",
    low: 0,
    high: 1,
    step: 0.01,
    ends: ["clean", "velvet"],
    standard: 0,
  },
  "sheen.roughness": {
    label: "Length of the nap",
    tip: "Roughness of the sheen: how far it spreads from the outline",
    low: 0,
    high: 1,
    step: 0.01,
    ends: ["short", "long"],
    standard: 0.4,
  },
  "variation.colour_noise": {
    label: "Threads of other lots",
    tip: "Spread of the colour from thread to thread: barré (colour_noise)",
    low: 0,
    high: 1,
    step: 0.01,
    ends: ["one lot", "many"],
    standard: 0,
  },
  "variation.irregularity": {
    label: "Uneven yarns",
    tip: "Multiplies how much the yarns of both families vary; 0 is even cloth (irregularity)",
    low: 0,
    high: 2,
    step: 0.05,
    ends: ["even", "twice as uneven"],
    standard: IRREGULARITY,
  },
  "variation.fibre_noise": {
    label: "Sparkle",
    tip: "How much the highlight varies from fibre to fibre",
    low: 0,
    high: 1,
    step: 0.01,
    ends: ["smooth", "lively"],
    standard: 0,
  },
  wear: {
    label: "Wear",
    tip: "How much rubbing has taken the dye off yarns that lie on the face (wear)",
    low: 0,
    high: 1,
    step: 0.01,
    ends: ["new", "worn out"],
    standard: 0,
  },
  diffuse_blend: {
    label: "Roundness in the shade",
    tip: "w: how much diffuse light follows the yarn's own normal rather than the cloth's",
    low: 0,
    high: 1,
    step: 0.01,
    ends: ["flat", "round"],
    standard: DIFFUSE_BLEND,
  },
  optical_depth: {
    label: "Density of fibres",
    tip: "Tρ: optical depth of the fibre layer",
    low: 0.05,
    high: 10,
    step: 0.05,
    ends: ["loose", "dense"],
    standard: OPTICAL_DEPTH,
  },
};

/** A sentence in which fields are called as the page calls them: "Picks per cm" for `picks_per_cm`. */
export function inWords(sentence: string): string {
  return sentence.replace(/\b(?:(warp|weft)\.)?([a-z]+(?:[_.][a-z]+)*)(?= = |:)/g, (field: string, family: string | undefined, name: string) => {
    const quantities = family === undefined ? CLOTH_QUANTITIES : YARN_QUANTITIES;
    const label = Object.hasOwn(quantities, name) ? quantities[name]!.label : undefined;
    if (label === undefined) return field;
    return family === undefined ? label : `${label} of the ${family}`;
  });
}
