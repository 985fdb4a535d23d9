/** Whole fabrics to begin with: the user's own, and those that come with the page. */
import { clamp } from "loomlight-fabric";
import type { Draft } from "loomlight-fabric";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";

import type { GalleryEntry } from "loomlight-fabric";
import { Icon } from "../controls/Icon.tsx";
import { Fault } from "../controls/written.tsx";
import { keepFabric, removeFabric, useOwnFabrics } from "../keeping/own_fabrics.ts";
import { woven, type Fabric } from "../state/document.ts";
import { fabricFromJson } from "../state/fabric_json.ts";
import type { Dispatch } from "../state/store.ts";
import { clothPicture } from "../view/cloth_picture.ts";
import { isFound, saidOf } from "./found.ts";

interface Props {
  readonly fabric: Fabric;
  readonly gallery: readonly GalleryEntry[];
  /** Words that all fabrics shown have. */
  readonly sought: string;
  readonly dispatch: Dispatch;
}

export function Gallery({ fabric, gallery, sought, dispatch }: Props) {
  const own = useOwnFabrics();
  const [fault, setFault] = useState("");
  const given = useMemo(() => gallery.map((entry) => ({ entry, fabric: fabricFromJson({ fields: entry.fields, draft: entry.draft }) })), [gallery]);
  const foundOwn = own.filter((each) => isFound(sought, each.name, saidOf(each.fabric)));
  const found = given.filter((each) => isFound(sought, each.entry.name, saidOf(each.fabric)));
  const open = (opened: Fabric): void => dispatch({ type: "fabric/open", fabric: opened });
  return (
    <>
      <section class="group">
        <h2>Your fabrics</h2>
        {foundOwn.length > 0 && (
          <div class="tiles tiles-wide" data-testid="own-fabrics">
            {foundOwn.map(({ name, fabric: kept }) => (
              <div key={name} class="own-tile">
                <Tile name={name} title={`Open ${name}`} testid={`own-${name}`} picture={null} fabric={kept} current={fabric} onChoose={open} />
                <button type="button" class="icon-button" aria-label={`Remove ${name} from your fabrics`} title="Remove" onClick={() => removeFabric(name)}>
                  <Icon name="close" />
                </button>
              </div>
            ))}
          </div>
        )}
        <button type="button" class="button" data-testid="keep-fabric" onClick={() => setFault(keepFabric(fabric) ?? "")}>
          Keep this fabric
        </button>
        <Fault text={fault} />
        {own.length === 0 && <p class="note">The browser keeps it here, to begin with another time.</p>}
      </section>
      {given.length > 0 && (
        <section class="group">
          <h2>Fabrics</h2>
          <div class="tiles tiles-wide">
            {found.map((each) => (
              <Tile key={each.entry.id} name={each.entry.name} title={each.entry.description} testid={`fabric-${each.entry.id}`} picture={each.entry.picture} fabric={each.fabric} current={fabric} onChoose={open} />
            ))}
          </div>
          {found.length === 0 && <p class="note">None of the {given.length} fabrics has “{sought.trim()}”.</p>}
        </section>
      )}
    </>
  );
}

interface TileProps {
  readonly name: string;
  readonly title: string;
  readonly testid: string;
  readonly picture: string | null;
  readonly fabric: Fabric;
  readonly current: Fabric;
  readonly onChoose: (fabric: Fabric) => void;
}

function Tile({ name, title, testid, picture, fabric, current, onChoose }: TileProps) {
  return (
    <button type="button" class={`tile${fabric === current ? " is-chosen" : ""}`} aria-pressed={fabric === current} title={title} data-testid={testid} onClick={() => onChoose(fabric)}>
      {picture === null ? <DrawnCloth fabric={fabric} /> : <img src={picture} alt="" width={160} height={100} />}
      <span>{name}</span>
    </button>
  );
}

/** Its threads drawn flat; of figured cloth a corner, as the whole of it would be dots. */
function DrawnCloth({ fabric }: { fabric: Fabric }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const draft = woven(fabric);
    const side = Math.min(draft.ends, 16);
    const corner = cropped(draft, side, Math.min(draft.picks, 12));
    const picture = clothPicture(corner, { pixels: clamp(Math.round(128 / side), 4, 13), gap: { warp: 0.06, weft: 0.06 } });
    const tile = document.createElement("canvas");
    tile.width = picture.width;
    tile.height = picture.height;
    tile.getContext("2d")!.putImageData(new ImageData(picture.rgba, picture.width, picture.height), 0, 0);
    const context = canvas.current!.getContext("2d")!;
    context.fillStyle = context.createPattern(tile, "repeat")!;
    context.fillRect(0, 0, canvas.current!.width, canvas.current!.height);
  }, [fabric]);
  return <canvas ref={canvas} width={160} height={100} aria-hidden="true" />;
}

function cropped(draft: Draft, ends: number, picks: number): Draft {
  if (ends === draft.ends && picks === draft.picks) return draft;
  const drawdown = new Uint8Array(ends * picks);
  for (let pick = 0; pick < picks; pick++)
    drawdown.set(draft.drawdown.subarray(pick * draft.ends, pick * draft.ends + ends), pick * ends);
  return { ...draft, ends, picks, drawdown };
}
