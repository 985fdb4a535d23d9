/** Values in a weaving information file: numbers, lists, yes and no, lengths, each with its complaint. */
import { MAXIMUM_THREADS } from "./draft.ts";
import { ascending } from "./loom.ts";
import { general } from "./numbers.ts";
import type { WifText } from "./wif_text.ts";

const TRUE: ReadonlySet<string> = new Set(["true", "yes", "on", "1", "t", "y"]);
const FALSE: ReadonlySet<string> = new Set(["false", "no", "off", "0", "f", "n"]);
const INTEGER = /^[+-]?[0-9]{1,9}$/;
const NUMBER = /^[+-]?([0-9]+[.,]?[0-9]*|[.,][0-9]+)([eE][+-]?[0-9]+)?$/;

/** Millimetres; the specification's decipoint is a tenth of 1/72 inch. */
export const UNIT_MM: Readonly<Record<string, number>> = {
  decipoints: 25.4 / 720,
  inches: 25.4,
  centimeters: 10,
  millimeters: 1,
};
const UNIT_SPELLINGS: Readonly<Record<string, string>> = {
  decipoint: "decipoints",
  inch: "inches",
  in: "inches",
  centimeter: "centimeters",
  centimetre: "centimeters",
  centimetres: "centimeters",
  cm: "centimeters",
  millimeter: "millimeters",
  millimetre: "millimeters",
  millimetres: "millimeters",
  mm: "millimeters",
};
/** Beyond these a thread is no thread; rounding of lengths stays harmless between them. */
const MIN_LENGTH_MM = 1e-4;
const MAX_LENGTH_MM = 1000;

/** A value up to a comment on its line. */
export function withoutComment(value: string): string {
  const comment = value.indexOf(";");
  return (comment < 0 ? value : value.slice(0, comment)).trim();
}

/** Whether a text is a whole number of at most nine digits. */
export function isInteger(digits: string): boolean {
  return INTEGER.test(digits);
}

/**
 * The value as a whole number from `lowest` to `highest`; `what` names what it counts.
 *
 * @throws InputError it is none, or out of that range.
 */
export function integer(
  text: WifText,
  section: string,
  key: string,
  value: string,
  lowest: number,
  highest: number,
  what: string,
): number {
  const digits = withoutComment(value);
  const number = INTEGER.test(digits) ? Number(digits) : NaN;
  if (number > highest)
    throw text.fault(section, key, value, `is above ${highest}, and at most so many can be used`);
  if (!(lowest <= number && number <= highest))
    throw text.fault(section, key, value, `is not ${what}: it must be a whole number, ${lowest} to ${highest}`);
  return number;
}

/**
 * The key as a 1-based number of a thread, a treadle or a colour.
 *
 * @throws InputError it is none, or above 16384.
 */
export function threadNumber(text: WifText, section: string, key: string, value: string, what: string): number {
  const number = INTEGER.test(key) ? Number(key) : NaN;
  if (number > MAXIMUM_THREADS)
    throw text.fault(section, key, value, `is ${what} above ${MAXIMUM_THREADS}, the highest that can be used`);
  if (!(1 <= number && number <= MAXIMUM_THREADS))
    throw text.fault(
      section,
      key,
      value,
      `does not begin with ${what}, a whole number from 1 to ${MAXIMUM_THREADS}`,
    );
  return number;
}

/**
 * A list such as "1,3,4"; 0 and nothing stand for none.
 *
 * @throws InputError an entry is no whole number from 0 to 16384.
 */
export function numberSet(text: WifText, section: string, key: string, value: string, what: string): number[] {
  const parts = withoutComment(value)
    .split(",")
    .map((part) => part.trim())
    .filter((part) => part !== "");
  const numbers = parts.map((part) => (INTEGER.test(part) ? Number(part) : NaN));
  if (!numbers.every((number) => 0 <= number && number <= MAXIMUM_THREADS))
    throw text.fault(
      section,
      key,
      value,
      `is no list of ${what}: whole numbers from 0 to ${MAXIMUM_THREADS} with commas`,
    );
  return ascending(numbers.filter((number) => number !== 0));
}

/**
 * A list of as many whole numbers as one of `counts`; `what` says what it is and how it is written.
 *
 * @throws InputError another number of them, or no numbers.
 */
export function integers(
  text: WifText,
  section: string,
  key: string,
  value: string,
  counts: readonly number[],
  what: string,
): number[] {
  const parts = withoutComment(value)
    .split(",")
    .map((part) => part.trim());
  if (!counts.includes(parts.length) || !parts.every((part) => INTEGER.test(part)))
    throw text.fault(section, key, value, `is not ${what}`);
  return parts.map(Number);
}

/**
 * The value as a truth value, `standard` if the file does not say.
 *
 * @throws InputError it is none.
 */
export function yesOrNo(text: WifText, section: string, key: string, standard: boolean): boolean {
  const value = text.value(section, key);
  const word = withoutComment(value).toLowerCase();
  if (word === "") return standard;
  if (!TRUE.has(word) && !FALSE.has(word)) throw text.fault(section, key, value, 'is neither "true" nor "false"');
  return TRUE.has(word);
}

/** A unit's name as `UNIT_MM` has it; unknown names stay as they are, in lower case. */
export function unitName(spelled: string): string {
  const name = spelled.trim().toLowerCase();
  return Object.hasOwn(UNIT_SPELLINGS, name) ? UNIT_SPELLINGS[name]! : name;
}

/**
 * Millimetres in the section's Units; null if it names none.
 *
 * @throws InputError an unknown unit.
 */
export function unitMm(text: WifText, section: string): number | null {
  const value = text.value(section, "Units");
  const name = unitName(withoutComment(value));
  if (name === "") return null;
  if (!Object.hasOwn(UNIT_MM, name))
    throw text.fault(section, "Units", value, "is no known unit: write Decipoints, Inches or Centimeters");
  return UNIT_MM[name]!;
}

/**
 * The value in millimetres; null if it is empty or 0, which programs write for "not said".
 *
 * @throws InputError it is no number, or no length that a thread can have.
 */
export function lengthMm(text: WifText, section: string, key: string, value: string, unit: number): number | null {
  const digits = withoutComment(value);
  if (digits === "") return null;
  if (!NUMBER.test(digits) || digits.length > 40)
    throw text.fault(section, key, value, "is no length: write a decimal number such as 0.05");
  const length = Number(digits.replace(",", ".")) * unit;
  if (length === 0 && !/[1-9]/.test(digits.toLowerCase().split("e")[0]!)) {
    text.warn(section, key, value, "is no length and is passed over; a thread takes up more than 0");
    return null;
  }
  if (!(MIN_LENGTH_MM <= length && length <= MAX_LENGTH_MM))
    throw text.fault(
      section,
      key,
      value,
      `is ${general(length, 4)} mm, and a thread measures between ${MIN_LENGTH_MM} and ${MAX_LENGTH_MM} mm`,
    );
  return length;
}
