/** A fabric from a photograph of cloth: asks how wide it is and how it was lit, and shows how far Python is. */
import type { CaptureJson } from "loomlight-fabric";
import { messageOf } from "loomlight-fabric";
import { useEffect, useRef, useState } from "preact/hooks";

import type { Server } from "./api.ts";
import { Segmented } from "./controls/Segmented.tsx";
import { YARN_QUANTITIES } from "./controls/symbols.ts";
import { numberOf } from "./controls/written.tsx";
import { sentence } from "./state/store.ts";

interface Props {
  readonly file: File;
  readonly server: Server;
  readonly onFound: (found: CaptureJson) => void;
  readonly onClose: () => void;
}

type Light = "flash" | "window";

export function CaptureDialog({ file, server, onFound, onClose }: Props) {
  const dialog = useRef<HTMLDialogElement>(null);
  const work = useRef<AbortController | null>(null);
  const [width, setWidth] = useState("");
  const [light, setLight] = useState<Light>("flash");
  const [share, setShare] = useState<number | null>(null);
  const [fault, setFault] = useState<string | null>(null);

  useEffect(() => {
    dialog.current!.showModal();
    // Who leaves waits for nothing.
    return () => work.current?.abort();
  }, []);

  const start = async (): Promise<void> => {
    const millimetres = numberOf(width);
    if (millimetres === null || millimetres <= 0) return setFault("Say how many millimetres of cloth the picture is wide.");
    work.current = new AbortController();
    setFault(null);
    setShare(0);
    try {
      const found = await server.capture(file, millimetres, light, setShare, work.current.signal);
      onFound(found);
      dialog.current?.close();
    } catch (error) {
      if (!work.current.signal.aborted) setFault(sentence(messageOf(error)));
      setShare(null);
    }
  };

  return (
    <dialog ref={dialog} class="export" aria-label="A fabric from a photograph" onClose={onClose} data-testid="capture">
      <h2>A fabric from a photograph</h2>
      <p>
        {file.name} should show flat cloth from straight above, its warp running upwards, six pixels a thread or more, and nothing else. It takes a minute or
        two.
      </p>
      <label>
        Width of the cloth in it{" "}
        <input type="number" min={1} max={2000} step="any" value={width} disabled={share !== null} data-testid="capture-width" onInput={(event) => setWidth(event.currentTarget.value)} /> mm
      </label>
      <Segmented
        label="Light"
        choices={[
          ["flash", "Flash at the camera"],
          ["window", "Window at a side"],
        ]}
        value={light}
        onChoose={setLight}
        testid="capture-light"
        isDisabled={share !== null}
      />
      <div class="export-said" role="status" data-testid="capture-status">
        {share !== null && (
          <>
            <progress value={share} aria-label="Progress" data-testid="capture-progress" />
            <span>{Math.floor(100 * share)} %</span>
          </>
        )}
        {fault !== null && (
          <span class="export-fault" role="alert" data-testid="capture-fault">
            {fault}
          </span>
        )}
      </div>
      <div class="export-buttons">
        <button
          type="button"
          class="button"
          data-testid="capture-cancel"
          onClick={() => (share === null ? dialog.current!.close() : work.current!.abort())}
        >
          {share === null ? "Close" : "Cancel"}
        </button>
        <button type="button" class="button is-primary" disabled={share !== null} data-testid="capture-start" onClick={() => void start()}>
          Capture
        </button>
      </div>
    </dialog>
  );
}

/** What is said of a fabric that was found: its doubts, and the fields that the photograph does not fix. */
export function warningsOf({ doubts, unfixed }: CaptureJson): string[] {
  const said = doubts.map(sentence);
  if (unfixed.length === 0) return said;
  const names = unfixed.map((field) => {
    const [family, name] = field.split(".") as [string, string];
    return `${YARN_QUANTITIES[name]?.label ?? name} of the ${family}`;
  });
  return [...said, `The photograph does not fix ${names.join(", ")}: these are of the kind of yarn.`];
}
