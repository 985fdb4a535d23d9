/** A fault of the user's input: one clear sentence that names the field, the value and what would be right. */
export class InputError extends Error {
  override readonly name = "InputError";
}

/** Receives one sentence about input that is used although something in it is wrong. */
export type Warn = (sentence: string) => void;

/** Whether `error` is a fault of the input, whose message may be shown as it is. */
export function isInputError(error: unknown): error is InputError {
  return error instanceof InputError;
}

/** What an error says. */
export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
