/** The piece for which yarn was reckoned, kept in the browser. */
import { FIRST_PLAN, PLAN_RANGES, type WeavingPlan } from "loomlight-fabric";

import { tableOf } from "../state/json_table.ts";
import { read, write } from "./slots.ts";

/** Whether a number of a plan can be; null stands for a take-up that follows from the weave. */
export function isPossible(name: keyof WeavingPlan, value: unknown): boolean {
  const [low, high] = PLAN_RANGES[name];
  if (value === null) return FIRST_PLAN[name] === null;
  return typeof value === "number" && value >= low && value <= high;
}

/** The plan of a text; what it does not say, or cannot be, is that of a fresh page. */
export function planOf(text: string | null): WeavingPlan {
  let json: unknown = null;
  try {
    json = JSON.parse(text ?? "null");
  } catch {
    // Of another version of the page.
  }
  const given = tableOf(json);
  const names = Object.keys(FIRST_PLAN) as (keyof WeavingPlan)[];
  const entries = names.map((name) => [name, Object.hasOwn(given, name) && isPossible(name, given[name]) ? given[name] : FIRST_PLAN[name]]);
  return Object.fromEntries(entries) as WeavingPlan;
}

export const readPlan = (): WeavingPlan => planOf(read("plan"));

export function keepPlan(plan: WeavingPlan): void {
  write("plan", JSON.stringify(plan));
}
