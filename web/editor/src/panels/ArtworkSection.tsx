/** The artwork that the cloth is woven of: which weave each of its colours is, its wefts and its longest float. */
import {
  artworkFacts,
  BACK_WEAVE,
  colourShares,
  FAMILIES,
  familySpacing,
  plainHex,
  weaveLists,
  weaveNames,
  type Artwork,
} from "loomlight-fabric";
import { useMemo } from "preact/hooks";

import { Stepper } from "../controls/Stepper.tsx";
import { Fault, useWritten } from "../controls/written.tsx";
import { hasWeaves, isArtwork, type Fabric, type WovenOfArtwork } from "../state/document.ts";
import { refusalOf, type Dispatch } from "../state/store.ts";

const MM_PER_CM = 10;

interface Props {
  readonly fabric: Fabric;
  readonly dispatch: Dispatch;
}

export function ArtworkSection({ fabric, dispatch }: Props) {
  const { artwork, fields } = fabric;
  if (artwork === undefined && !hasWeaves(fields)) return null;
  return (
    <section class="group" data-testid="artwork">
      <h2>Artwork</h2>
      {artwork === undefined ? (
        <p class="note">The cloth is woven of {fields.image}, which is not here: open it together with its fabric file to give its colours other weaves.</p>
      ) : isArtwork(fabric) ? (
        <Weaves fabric={fabric} dispatch={dispatch} />
      ) : (
        <p class="note">
          {fields.image} has {countOf(artwork.colours.length, "colour")}, and is read as a drawdown.{" "}
          <button type="button" class="text-button" data-testid="artwork-as-weaves" onClick={() => dispatch({ type: "artwork/read", as: "weaves" })}>
            Make each colour a weave
          </button>
        </p>
      )}
    </section>
  );
}

function Weaves({ fabric, dispatch }: { readonly fabric: WovenOfArtwork; readonly dispatch: Dispatch }) {
  const { artwork, fields } = fabric;
  const image = fields.image ?? "";
  const facts = useMemo(() => artworkFacts(artwork, fields, image), [artwork, fields.weaves, fields.artwork]);
  const shares = useShares(artwork);
  const names = useMemo(() => [...weaveNames(), ...(facts.wefts > 1 ? [BACK_WEAVE] : [])], [facts.wefts]);
  const isOwnLimit = fields.artwork?.longest_float === undefined;
  const setLimit = (value: number | undefined): string | null => refusalOf(dispatch, { type: "field/set", field: "artwork.longest_float", value });
  return (
    <>
      <p class="note">
        The colours of {image} say which weave lies where. What the threads look like is said under{" "}
        <button type="button" class="text-button" onClick={() => dispatch({ type: "tab/show", tab: "colour" })}>
          Colour
        </button>{" "}
        and{" "}
        <button type="button" class="text-button" onClick={() => dispatch({ type: "tab/show", tab: "yarns" })}>
          Yarns
        </button>
        .
      </p>
      <datalist id="artwork-weaves">
        {names.map((name) => (
          <option key={name} value={name} />
        ))}
      </datalist>
      <ul class="artwork-colours" aria-label={countOf(weaveLists(fields.weaves!).size, "colour")}>
        {Object.entries(fields.weaves!).map(([colour, given]) => (
          <ColourRow key={colour} colour={colour} weaves={typeof given === "string" ? [given] : given} share={shares.get(plainHex(colour)) ?? 0} dispatch={dispatch} />
        ))}
      </ul>
      <p class="note" data-testid="artwork-size">
        {sizeText(fabric)}
      </p>
      {facts.cut !== null && <p class="note">{facts.cut}</p>}
      <div class="steppers">
        <Stepper label="Longest float" testid="artwork-longest" value={facts.longestFloat} onValue={setLimit} />
        <Stepper label="Wefts" testid="artwork-wefts" value={facts.wefts} onValue={(wefts) => refusalOf(dispatch, { type: "artwork/wefts", wefts })} />
      </div>
      {!isOwnLimit && (
        <button type="button" class="button" data-testid="artwork-own-longest" onClick={() => setLimit(undefined)}>
          Bind floats as the weaves do
        </button>
      )}
      {facts.wefts > 1 && <WeftFields fabric={fabric} dispatch={dispatch} />}
      <p class="note">
        Are dark crossings those where the warp is on top?{" "}
        <button type="button" class="text-button" data-testid="artwork-as-drawdown" onClick={() => dispatch({ type: "artwork/read", as: "drawdown" })}>
          Read it as a drawdown
        </button>
      </p>
    </>
  );
}

interface RowProps {
  readonly colour: string;
  /** One a weft. */
  readonly weaves: readonly string[];
  readonly share: number;
  readonly dispatch: Dispatch;
}

function ColourRow({ colour, weaves, share, dispatch }: RowProps) {
  const hex = plainHex(colour);
  const set = (weft: number, weave: string): string | null => {
    const next = weaves.map((each, at) => (at === weft ? weave : each));
    return refusalOf(dispatch, { type: "field/set", field: `weaves.${colour}`, value: next.length === 1 ? next[0] : next });
  };
  return (
    <li>
      <span class="artwork-swatch" style={{ background: hex }} aria-hidden="true" />
      <span>
        {hex}
        <small>{shareText(share)}</small>
      </span>
      <div>
        {weaves.map((weave, weft) => (
          <WeaveField
            key={weft}
            label={`Weave of ${hex}${weaves.length > 1 ? `, weft ${weft + 1}` : ""}`}
            testid={`artwork-${hex.slice(1)}-${weft + 1}`}
            weave={weave}
            onWeave={(text) => set(weft, text)}
          />
        ))}
      </div>
    </li>
  );
}

interface WeaveFieldProps {
  readonly label: string;
  readonly testid: string;
  readonly weave: string;
  /** Why a weave is refused, or null. */
  readonly onWeave: (weave: string) => string | null;
}

function WeaveField({ label, testid, weave, onWeave }: WeaveFieldProps) {
  const written = useWritten(weave, onWeave);
  return (
    <>
      <input {...written.input} class="text" list="artwork-weaves" aria-label={label} data-testid={testid} />
      <Fault text={written.fault} />
    </>
  );
}

/** In which order wefts follow each other, and which of them add nothing to the length of the cloth. */
function WeftFields({ fabric, dispatch }: { readonly fabric: WovenOfArtwork; readonly dispatch: Dispatch }) {
  const { order = "", regulator } = fabric.fields.artwork ?? {};
  const set = (field: string, value: unknown): string | null => refusalOf(dispatch, { type: "field/set", field: `artwork.${field}`, value });
  const ordered = useWritten(order, (text) => set("order", text.trim() === "" ? undefined : text));
  const extra = useWritten(regulator === undefined ? "" : String(regulator), (text) => set("regulator", text.trim() === "" ? undefined : Number(text)));
  return (
    <>
      <label class="row is-field">
        <span>Order</span>
        <input {...ordered.input} class="text" placeholder="one of each: 1 2" data-testid="artwork-order" />
        <Fault text={ordered.fault} />
      </label>
      <label class="row is-field">
        <span>Extra from</span>
        <input {...extra.input} class="text" inputMode="numeric" placeholder="no weft: all take up cloth" data-testid="artwork-regulator" />
        <Fault text={extra.fault} />
      </label>
    </>
  );
}

/** Shares of an artwork's pixels by colour. */
function useShares(artwork: Artwork): ReadonlyMap<string, number> {
  return useMemo(() => {
    const shares = colourShares(artwork);
    return new Map(artwork.colours.map((colour, at) => [colour, shares[at]!]));
  }, [artwork]);
}

function shareText(share: number): string {
  if (share === 0) return "nowhere";
  return share < 0.001 ? "< 0.1 %" : `${(100 * share).toFixed(1)} %`;
}

/** Threads of the cloth, its setts, and how large one repeat is. */
function sizeText({ fields, draft }: WovenOfArtwork): string {
  const [across, along] = FAMILIES.map((family) => familySpacing(fields, family, draft).reduce((sum, each) => sum + each, 0) / MM_PER_CM);
  const sett = (threads: number, length: number): string => `${Number((threads / length).toPrecision(3))}`;
  return (
    `${draft.ends} ends and ${draft.picks} picks, ${sett(draft.ends, across!)} × ${sett(draft.picks, along!)} a centimetre: ` +
    `${across!.toPrecision(3)} × ${along!.toPrecision(3)} cm.`
  );
}

const countOf = (count: number, thing: string): string => `${count} ${thing}${count === 1 ? "" : "s"}`;
