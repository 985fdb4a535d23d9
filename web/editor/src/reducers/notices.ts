/** Sentences that the page tells: faults, warnings, and what was done. */
import { NOTICE_KINDS, type Notice } from "../state/document.ts";
import { requireOneOf, shown } from "./checks.ts";

/** More would cover the cloth. */
const MAX = 2;

/** The notices with one more; one that is there already is not told twice. */
export function withNotice(notices: readonly Notice[], notice: Omit<Notice, "id">): readonly Notice[] {
  const { kind, text, offer, topic } = notice;
  requireOneOf("kind", kind, NOTICE_KINDS);
  const others = notices.filter((notice) => notice.text !== text);
  const id = notices.reduce((most, notice) => Math.max(most, notice.id), 0) + 1;
  return [...others, { id, kind, text: typeof text === "string" ? text : shown(text), ...(offer === undefined ? {} : { offer }), ...(topic === undefined ? {} : { topic }) }].slice(-MAX);
}

/** The notices without those of a topic. */
export function withoutTopic(notices: readonly Notice[], topic: NonNullable<Notice["topic"]>): readonly Notice[] {
  return notices.some((notice) => notice.topic === topic) ? notices.filter((notice) => notice.topic !== topic) : notices;
}

/** The notices without one. */
export function withoutNotice(notices: readonly Notice[], id: number): readonly Notice[] {
  return notices.filter((notice) => notice.id !== id);
}
