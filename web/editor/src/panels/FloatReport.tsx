/** Floats that are too long: marks of them, how many, the longest, and where each is. */
import { MAXIMUM_THREADS, type Float, type LongFloats, type Region } from "loomlight-fabric";

import { Stepper } from "../controls/Stepper.tsx";

interface Props {
  readonly floats: LongFloats | null;
  readonly limit: number | null;
  readonly onLimit: (limit: number | null) => void;
  /** Goes to a float. */
  readonly onFloat: (float: Float) => void;
}

/** Marks floats that cross more threads than one wants, and lists them. */
export function FloatReport({ floats, limit, onLimit, onFloat }: Props) {
  return (
    <section class="group">
      <h2>Floats</h2>
      <label class="row">
        <input type="checkbox" checked={limit !== null} data-testid="floats-marked" onChange={(event) => onLimit(event.currentTarget.checked ? 5 : null)} />
        <span>Mark long floats</span>
      </label>
      {limit !== null && (
        <Stepper
          label="Longer than"
          testid="floats-limit"
          value={limit}
          onValue={(value) => {
            if (!Number.isInteger(value) || value < 1 || value > MAXIMUM_THREADS) return `Write a whole number from 1 to ${MAXIMUM_THREADS}.`;
            onLimit(value);
            return null;
          }}
        />
      )}
      {floats !== null && (
        <p class="note" data-testid="floats">
          {floats.onFace + floats.onBack === 0 ? "None is longer. " : `${floats.onFace} on the face (spots), ${floats.onBack} on the back (rings) a repeat. `}
          Longest: warp {floats.longest.warpFace} on the face, {floats.longest.warpBack} on the back; weft {floats.longest.weftFace} and {floats.longest.weftBack}.
        </p>
      )}
      {floats !== null && floats.reported.length > 0 && (
        <>
          <ol class="float-list" aria-label="Longest floats">
            {floats.reported.map((float, index) => (
              <li key={index}>
                <button type="button" class="text-button" data-testid={`float-${index}`} onClick={() => onFloat(float)}>
                  {placeOf(float)}
                </button>
                <span>
                  {float.length}, {float.isFace ? "face" : "back"}
                </span>
              </li>
            ))}
          </ol>
          {floats.reported.length < floats.onFace + floats.onBack && <p class="note">The {floats.reported.length} longest are listed.</p>}
        </>
      )}
    </section>
  );
}

/** The crossings of a float up to the repeat's edge. */
export function regionOf({ family, thread, first, length }: Float): Region {
  return family === "warp"
    ? { firstEnd: thread, firstPick: first, ends: 1, picks: length }
    : { firstEnd: first, firstPick: thread, ends: length, picks: 1 };
}

function placeOf({ family, thread, first }: Float): string {
  return family === "warp" ? `End ${thread + 1} from pick ${first + 1}` : `Pick ${thread + 1} from end ${first + 1}`;
}
