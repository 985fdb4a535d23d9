/** Name of the fabric, undo and redo, opening, saving, sharing and comparing. */
import { useEffect, useRef, useState } from "preact/hooks";

import { Icon, type IconName } from "./controls/Icon.tsx";
import { useWritten } from "./controls/written.tsx";
import { nameOf, type State } from "./state/document.ts";
import { refusalOf, type Dispatch } from "./state/store.ts";

/** What can be saved. */
export type SaveFormat = "toml" | "wif" | "png" | "export";

interface Props {
  readonly state: State;
  readonly dispatch: Dispatch;
  /** Whether the cloth is shown flat: models then make no difference. */
  readonly isFlat: boolean;
  readonly onOpen: () => void;
  readonly onSave: (format: SaveFormat) => void;
  /** Null where the page has no address of its own. */
  readonly onLink: (() => void) | null;
}

const FORMATS: readonly (readonly [SaveFormat, string, string])[] = [
  ["toml", "Fabric", "the file loomlight reads everywhere (.toml)"],
  ["wif", "Draft", "for weaving software (.wif)"],
  ["png", "Picture", "as you see it now (.png)"],
  ["export", "Export …", "a picture of any size, maps, glTF, a material"],
];

export function TopBar({ state, dispatch, isFlat, onOpen, onSave, onLink }: Props) {
  const { past, future } = state.history;
  const written = useWritten(nameOf(state.fabric), (text) => {
    const name = text.trim();
    return refusalOf(dispatch, { type: "field/set", field: "name", value: name === "" ? undefined : name });
  });
  return (
    <header class="top-bar">
      <h1>
        <span class="brand">loomlight</span>
      </h1>
      <input {...written.input} class="fabric-name" aria-label="Name of the fabric" title={written.fault} data-testid="fabric-name" />
      <div class="top-group">
        <IconButton icon="undo" label="Undo" keys="Ctrl+Z" testid="undo" isOff={past.length === 0} onClick={() => dispatch({ type: "history/undo" })} />
        <IconButton icon="redo" label="Redo" keys="Ctrl+Shift+Z" testid="redo" isOff={future.length === 0} onClick={() => dispatch({ type: "history/redo" })} />
      </div>
      <div class="top-group top-actions">
        <button type="button" class="button" data-testid="open" onClick={onOpen} title="Open a fabric (.toml), a draft (.wif, a picture), or a mesh; or drop it on the page">
          <Icon name="open" />
          <span>Open</span>
        </button>
        <CompareMenu state={state} dispatch={dispatch} isFlat={isFlat} />
        {onLink !== null && (
          <button type="button" class="button" data-testid="link" onClick={onLink} title="Copy a link that carries this fabric">
            <Icon name="link" />
            <span>Link</span>
          </button>
        )}
        <Menu label="Save" icon="save" testid="save" isPrimary>
          {(close) =>
            FORMATS.map(([format, text, hint]) => (
              <button
                key={format}
                type="button"
                role="menuitem"
                data-testid={`save-${format}`}
                onClick={() => {
                  close();
                  onSave(format);
                }}
              >
                <strong>{text}</strong>
                <span>{hint}</span>
              </button>
            ))
          }
        </Menu>
      </div>
    </header>
  );
}

function IconButton(props: { icon: IconName; label: string; keys: string; testid: string; isOff: boolean; onClick: () => void }) {
  return (
    <button type="button" class="icon-button" aria-label={props.label} title={`${props.label} (${props.keys})`} disabled={props.isOff} data-testid={props.testid} onClick={props.onClick}>
      <Icon name={props.icon} />
    </button>
  );
}

function CompareMenu({ state, dispatch, isFlat }: { state: State; dispatch: Dispatch; isFlat: boolean }) {
  const { mode, before } = state.comparison;
  const item = (testid: string, title: string, hint: string, onChoose: () => void, close: () => void, isOff = false) => (
    <button
      type="button"
      role="menuitem"
      data-testid={testid}
      disabled={isOff}
      onClick={() => {
        close();
        onChoose();
      }}
    >
      <strong>{title}</strong>
      <span>{hint}</span>
    </button>
  );
  return (
    <Menu label="Compare" icon="compare" testid="compare" isOn={mode !== "off"}>
      {(close) => [
        item("compare-keep", "Keep this as “before”", "then change the cloth and wipe between both", () => dispatch({ type: "comparison/keep" }), close),
        item("compare-exchange", "Exchange before and after", "go back to the kept one, keep this", () => dispatch({ type: "comparison/exchange" }), close, before === null),
        item("compare-models", "Two ways of rendering", isFlat ? "needs a browser with WebGPU" : "filtered against samples of points", () => dispatch({ type: "comparison/set", comparison: { mode: "models" } }), close, isFlat),
        item("compare-off", "Stop comparing", "", () => dispatch({ type: "comparison/set", comparison: { mode: "off" } }), close, mode === "off"),
      ]}
    </Menu>
  );
}

interface MenuProps {
  readonly label: string;
  readonly icon: IconName;
  readonly testid: string;
  readonly isPrimary?: boolean;
  readonly isOn?: boolean;
  readonly children: (close: () => void) => preact.ComponentChildren;
}

function Menu({ label, icon, testid, isPrimary, isOn, children }: MenuProps) {
  const [isOpen, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  const button = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    if (!isOpen) return;
    const outside = (event: Event): void => {
      if (!root.current!.contains(event.target as Node)) setOpen(false);
    };
    document.addEventListener("pointerdown", outside);
    root.current!.querySelector<HTMLElement>("[role=menuitem]:not(:disabled)")?.focus();
    return () => document.removeEventListener("pointerdown", outside);
  }, [isOpen]);
  const onKeyDown = (event: KeyboardEvent): void => {
    if (!isOpen) return;
    if (event.key === "Escape") {
      setOpen(false);
      button.current!.focus();
    }
    const step = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
    if (step === 0) return;
    event.preventDefault();
    const items = [...root.current!.querySelectorAll<HTMLElement>("[role=menuitem]:not(:disabled)")];
    const at = items.indexOf(document.activeElement as HTMLElement);
    items[(at + step + items.length) % items.length]?.focus();
  };
  return (
    <div class="menu" ref={root} onKeyDown={onKeyDown}>
      <button
        ref={button}
        type="button"
        class={`button${isPrimary === true ? " is-primary" : ""}${isOn === true ? " is-on" : ""}`}
        aria-label={label}
        aria-haspopup="menu"
        aria-expanded={isOpen}
        data-testid={testid}
        onClick={() => setOpen(!isOpen)}
      >
        <Icon name={icon} />
        <span>{label}</span>
      </button>
      {isOpen && (
        <div class="menu-items" role="menu" aria-label={label}>
          {children(() => {
            setOpen(false);
            button.current!.focus();
          })}
        </div>
      )}
    </div>
  );
}
