/** Weaves by name: "plain", "twill 3/1 s", "satin 8/3", "houndstooth", "damask 480". */
import { closeMatch } from "./close_match.ts";
import { makeDraft, type Draft, type Structure } from "./draft.ts";
import * as effects from "./effects.ts";
import { InputError } from "./errors.ts";
import * as figured from "./figured.ts";
import { lcm } from "./numbers.ts";
import * as structures from "./structures.ts";
import { MAXIMUM_NAMED_THREADS } from "./structures.ts";
import { tartan } from "./tartan.ts";

const NUMBERS = /^[0-9]+(?:\/[0-9]+)*$/;
/** "5-end satin", "8 shaft satin" */
const ENDS = /([0-9]) ?-? ?(?:end|shaft|harness)s?(?![\p{L}\p{N}_])/gu;
const FILLERS: ReadonlySet<string> = new Set(["weave", "cloth", "fabric"]);
const DIRECTIONS: ReadonlySet<string> = new Set(["z", "s"]);

/** Parser of the parameters after a weave's name. */
class Request {
  private readonly text: string;
  private readonly usage: string;
  private readonly words: string[];

  constructor(text: string, usage: string, words: string[]) {
    this.text = text;
    this.usage = usage;
    this.words = words;
  }

  fault(what: string): InputError {
    return new InputError(`weave = "${this.text}": ${what}; write it like "${this.usage}".`);
  }

  /** The next word as numbers joined by "/"; empty if it is none. */
  counts(): number[] {
    const word = this.words[0];
    if (word === undefined || !NUMBERS.test(word)) return [];
    this.words.shift();
    if (word.split("/").some((digits) => digits.length > 4))
      throw this.fault(`${word.slice(0, 20)} is more than ${MAXIMUM_NAMED_THREADS} threads`);
    const numbers = word.split("/").map(Number);
    if (Math.min(...numbers) < 1) throw this.fault(`${word} holds a 0, where every count is at least 1`);
    return numbers;
  }

  /** The next word as one number. */
  count(standard: number, lowest: number, highest = MAXIMUM_NAMED_THREADS): number {
    const found = this.counts();
    const numbers = found.length > 0 ? found : [standard];
    const [number] = numbers;
    if (number === undefined || numbers.length !== 1 || !(lowest <= number && number <= highest))
      throw this.fault(`${numbers.join("/")} is not one whole number from ${lowest} to ${highest}`);
    return number;
  }

  /** The next word as "a/b", or as "a" for a/a. */
  pair(standard = 2): [number, number] {
    const found = this.counts();
    const numbers = found.length > 0 ? found : [standard];
    const [first, last] = [numbers[0], numbers[numbers.length - 1]];
    if (numbers.length > 2 || first === undefined || last === undefined) throw this.fault("two numbers are needed");
    const total = numbers.reduce((sum, part) => sum + part, 0);
    this.limit(total, total);
    return [first, last];
  }

  /** The next word as an even number of counts, "2/1" or "3/1/1/2". */
  parts(standard: readonly number[] = []): readonly number[] {
    const found = this.counts();
    const numbers = found.length > 0 ? found : standard;
    if (numbers.length < 2 || numbers.length % 2 === 1)
      throw this.fault("an even number of counts is needed, up and down in turn");
    const total = numbers.reduce((sum, part) => sum + part, 0);
    this.limit(total, total);
    return numbers;
  }

  /** All words that are left, joined by spaces. */
  rest(): string {
    return this.words.splice(0).join(" ");
  }

  /** The next word as a direction, Z if there is none. */
  isZ(): boolean {
    const word = this.words[0];
    if (word === undefined || !DIRECTIONS.has(word)) return true;
    this.words.shift();
    return word === "z";
  }

  /** Refuses a repeat that is too large, before it is built. */
  limit(ends: number, picks: number): void {
    if (Math.max(ends, picks) > MAXIMUM_NAMED_THREADS)
      throw this.fault(
        `one repeat has ${ends} ends and ${picks} picks, and at most ${MAXIMUM_NAMED_THREADS} of each can be used`,
      );
  }

  /** Raises InputError if words are left. */
  end(): void {
    if (this.words.length > 0) throw this.fault(`"${this.words.join(" ")}" is not understood`);
  }
}

type Made = Structure | effects.Effect | Draft;

interface Weave {
  readonly make: (request: Request) => Made;
  readonly usage: string;
}

function satinCounts(request: Request): [number, number] {
  const numbers = request.counts();
  const ends = numbers[0];
  if (ends === undefined || numbers.length > 2) throw request.fault("the number of ends is missing");
  request.limit(ends, ends);
  const valid = structures.satinSteps(ends);
  if (valid.length === 0) throw request.fault(`no regular satin has ${ends} ends; 5, 7, 8 and more do`);
  const step = numbers[1] ?? structures.spreadSatinStep(ends)!;
  if (!valid.includes(step)) {
    const shown = valid.slice(0, 12).join(", ") + (valid.length > 12 ? " and more" : "");
    throw request.fault(
      `${step} is no step for ${ends} ends, since a step shares no divisor with ${ends} and is neither 1 nor ` +
        `${ends - 1}: ${shown}`,
    );
  }
  return [ends, step];
}

function basket(request: Request): Structure {
  const [ends, picks] = request.pair();
  request.limit(2 * ends, 2 * picks);
  return structures.basket(ends, picks);
}

const TWO_TWO = [2, 2];

function turned(request: Request, make: (parts: readonly number[], leg: number) => Structure): Structure {
  const parts = request.parts(TWO_TWO);
  const period = parts.reduce((total, part) => total + part, 0);
  const leg = request.count(2 * period, 2);
  request.limit(2 * leg, make === structures.herringbone ? period : 2 * leg);
  return make(parts, leg);
}

function waffle(request: Request): Structure {
  const cell = request.count(8, 4, 64);
  if (cell % 2 === 1) throw request.fault(`${cell} is odd, and a cell has an even number of threads`);
  return structures.waffle(cell / 2);
}

function houndstooth(request: Request): effects.Effect {
  const width = request.count(4, 1, MAXIMUM_NAMED_THREADS / 4);
  request.limit(lcm(4, 2 * width), lcm(4, 2 * width));
  return effects.houndstooth(width);
}

function sett(request: Request): Draft {
  const made = tartan(request.rest());
  if (typeof made === "string") throw request.fault(made);
  return effects.effectDraft(made.effect, made.title);
}

const third = Math.floor(MAXIMUM_NAMED_THREADS / 3);

const WEAVES: Readonly<Record<string, Weave>> = {
  plain: { make: () => structures.plain(), usage: "plain" },
  twill: { make: (request) => structures.twill(request.parts(), request.isZ()), usage: "twill 2/1 z" },
  satin: { make: (request) => structures.satin(...satinCounts(request)), usage: "satin 5/2" },
  sateen: { make: (request) => structures.sateen(...satinCounts(request)), usage: "sateen 5/2" },
  basket: { make: basket, usage: "basket 2/2" },
  "warp rib": { make: (request) => structures.warpRib(...request.pair()), usage: "warp rib 2/2" },
  "weft rib": { make: (request) => structures.weftRib(...request.pair()), usage: "weft rib 2/2" },
  herringbone: { make: (request) => turned(request, structures.herringbone), usage: "herringbone 2/2 8" },
  diamond: { make: (request) => turned(request, structures.diamondTwill), usage: "diamond 2/2 8" },
  waffle: { make: waffle, usage: "waffle 8" },
  crepe: { make: () => structures.crepe(), usage: "crepe" },
  houndstooth: { make: houndstooth, usage: "houndstooth 4" },
  hairline: { make: () => effects.hairline(), usage: "hairline" },
  "log cabin": {
    make: (request) => effects.logCabin(request.count(8, 2, MAXIMUM_NAMED_THREADS / 2)),
    usage: "log cabin 8",
  },
  "glen check": { make: (request) => effects.glenCheck(request.count(4, 1, 128)), usage: "glen check 4" },
  "shepherds check": {
    make: (request) => effects.shepherdsCheck(request.count(12, 2, MAXIMUM_NAMED_THREADS / 4)),
    usage: "shepherd's check 12",
  },
  gingham: {
    make: (request) => effects.gingham(request.count(16, 1, MAXIMUM_NAMED_THREADS / 2)),
    usage: "gingham 16",
  },
  pinstripe: { make: (request) => effects.pinstripe(request.count(24, 2, third)), usage: "pinstripe 24" },
  denim: { make: () => effects.denim(), usage: "denim" },
  chambray: { make: () => effects.chambray(), usage: "chambray" },
  tartan: { make: sett, usage: "tartan B24 W4 B24 R2 K24 G24 W2" },
  damask: { make: (request) => figured.damask(request.count(480, 1)), usage: "damask 480" },
  argyle: { make: (request) => figured.argyleCloth(request.count(64, 1)), usage: "argyle 64" },
  "diamond figure": { make: (request) => figured.diamondFigure(request.count(96, 1)), usage: "diamond figure 96" },
};

/** Names of cloths stand for the structure that most of them have; numbers are those that are left out. */
const OTHER_NAMES: Readonly<Record<string, string>> = {
  tabby: "plain",
  calico: "plain",
  muslin: "plain",
  poplin: "plain",
  taffeta: "plain",
  voile: "plain",
  gabardine: "twill 2/2",
  gaberdine: "twill 2/2",
  serge: "twill 2/2",
  drill: "twill 3/1",
  "weft faced satin": "sateen",
  "warp faced satin": "satin",
  oxford: "basket 2/1",
  panama: "basket",
  rib: "warp rib",
  "diamond twill": "diamond",
  "herringbone twill": "herringbone",
  honeycomb: "waffle",
  crêpe: "crepe",
  dogtooth: "houndstooth",
  "prince of wales": "glen check",
  "shepherd check": "shepherds check",
  hopsack: "basket",
  ogee: "damask",
};

/** One example of every named weave, in the form that `namedWeave` reads. */
export function weaveNames(): string[] {
  return Object.values(WEAVES).map((weave) => weave.usage);
}

/**
 * The draft of a weave's name: its structure, and for colour effects its default colours.
 *
 * Case and space do not matter, and numbers may come first: "2/2 twill", "5-end satin". Counts read along pick 1 from end 1, warp up first: "twill 3/1" has three ends up,
 * one down, and its diagonal rises to the right (Z) unless "s" follows.
 *
 * @throws InputError an unknown name, or numbers that make no such weave; the message says what would.
 */
export function namedWeave(text: string): Draft {
  const words = wordsOf(text);
  const [name, rest] = split(words);
  if (name === null) throw unknown(text, words);
  const weave = WEAVES[name]!;
  const request = new Request(text.trim().slice(0, 80), weave.usage, rest);
  const made = weave.make(request);
  request.end();
  const title = words.join(" ");
  if ("warp" in made) return made;
  return "structure" in made ? effects.effectDraft(made, title) : makeDraft(made, { name: title });
}

function wordsOf(text: string): string[] {
  return text
    .toLowerCase()
    .replace(/['’]/g, "")
    .replace(ENDS, "$1 ")
    .replace(/\s*\/\s*/g, "/")
    .replace(/(?<=[\p{L}_])(?=[0-9])|(?<=[0-9])(?=[\p{L}_])/gu, " ")
    .replace(/(?<=[\p{L}_])[-_](?=[\p{L}_])/gu, " ")
    .split(/\s+/)
    .filter((word) => word !== "");
}

/** The longest known name that `words` begin with, or that follows numbers, and the other words. */
function split(words: readonly string[]): [string | null, string[]] {
  const kept = words.filter((word) => !FILLERS.has(word));
  for (const [start, first] of kept.entries()) {
    for (let length = Math.min(kept.length - start, 3); length > 0; length--) {
      const said = kept.slice(start, start + length).join(" ");
      const meant = (Object.hasOwn(OTHER_NAMES, said) ? OTHER_NAMES[said]! : said).split(" ");
      const name = meant.filter((word) => !NUMBERS.test(word)).join(" ");
      if (!Object.hasOwn(WEAVES, name)) continue;
      const before = kept.slice(0, start).sort((a, b) => Number(DIRECTIONS.has(a)) - Number(DIRECTIONS.has(b)));
      const rest = [...before, ...kept.slice(start + length)];
      const isCounted = rest.some((word) => NUMBERS.test(word));
      return [name, isCounted ? rest : [...meant.filter((word) => NUMBERS.test(word)), ...rest]];
    }
    if (!DIRECTIONS.has(first) && !NUMBERS.test(first)) break;
  }
  return [null, [...words]];
}

function unknown(text: string, words: readonly string[]): InputError {
  const letters = words.filter((word) => !NUMBERS.test(word)).join(" ");
  const close = closeMatch(letters.slice(0, 80), [...Object.keys(WEAVES), ...Object.keys(OTHER_NAMES)]);
  const advice = close === null ? "" : `did you mean "${close}"? `;
  return new InputError(
    `weave = "${text.trim().slice(0, 80)}" is no weave that is known; ${advice}the weaves are ` +
      `${Object.keys(WEAVES).join(", ")}, or give the file of a draft.`,
  );
}
