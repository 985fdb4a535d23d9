/** Colour cards: a house's own standards, to paint with and to write by their names. */
import { messageOf } from "loomlight-fabric";
import { useRef, useState } from "preact/hooks";

import { Fault } from "../controls/written.tsx";
import { addCard, removeCard, useCards } from "../keeping/cards.ts";

interface Props {
  /** The colour to paint with. */
  readonly value: string;
  readonly onValue: (hex: string) => void;
}

/** Colours that are shown at once; a search finds the others. */
const MAX_SHOWN = 120;

export function ColourCards({ value, onValue }: Props) {
  const cards = useCards();
  const [chosen, choose] = useState("");
  const [sought, seek] = useState("");
  const [fault, setFault] = useState("");
  const files = useRef<HTMLInputElement>(null);
  const card = cards.find(({ name }) => name === chosen) ?? cards[0];
  const words = sought.trim().toLowerCase();
  const found = card?.colours.filter(({ name, hex }) => name.toLowerCase().includes(words) || hex.includes(words)) ?? [];
  const add = async (list: readonly File[]): Promise<void> => {
    const said: string[] = [];
    for (const file of list)
      try {
        said.push(...(await addCard(file)));
        choose("");
      } catch (error) {
        said.push(messageOf(error));
      }
    setFault(said.join(" "));
  };
  return (
    <section class="group">
      <h2>Colour cards</h2>
      {card === undefined ? (
        <p class="note">Your house's standards as a palette: Adobe Swatch Exchange, GIMP palette, or a table of names with hex or Lab. The browser keeps them.</p>
      ) : (
        <>
          <div class="row">
            {cards.length > 1 && (
              <select class="text" value={card.name} aria-label="Colour card" data-testid="card-choice" onChange={(event) => choose(event.currentTarget.value)}>
                {cards.map(({ name }) => (
                  <option key={name} value={name}>
                    {name}
                  </option>
                ))}
              </select>
            )}
            <input class="text" type="search" value={sought} placeholder={`Search ${card.colours.length} colours`} aria-label={`Search the card ${card.name}`} data-testid="card-search" onInput={(event) => seek(event.currentTarget.value)} />
          </div>
          <ul class="card" aria-label={card.name} data-testid="card">
            {found.slice(0, MAX_SHOWN).map(({ name, hex }, index) => (
              <li key={index}>
                <button type="button" aria-pressed={hex === value} title={`Paint with ${name}, ${hex}`} onClick={() => onValue(hex)}>
                  <i style={{ background: hex }} />
                  {name}
                </button>
              </li>
            ))}
          </ul>
          {found.length === 0 && <p class="note">The card has no colour called “{sought}”.</p>}
          {found.length > MAX_SHOWN && <p class="note">{found.length - MAX_SHOWN} more: write a part of the name.</p>}
        </>
      )}
      <div class="row">
        <button type="button" class="button" data-testid="card-add" onClick={() => files.current!.click()}>
          Add a card (.ase, .gpl, .csv)
        </button>
        {card !== undefined && (
          <button type="button" class="text-button" data-testid="card-remove" onClick={() => removeCard(card.name)}>
            Remove {card.name}
          </button>
        )}
      </div>
      <Fault text={fault} />
      <input
        ref={files}
        type="file"
        accept=".ase,.gpl,.csv"
        multiple
        hidden
        aria-label="Colour cards to add"
        data-testid="card-files"
        onChange={(event) => {
          const list = [...(event.currentTarget.files ?? [])];
          event.currentTarget.value = "";
          void add(list);
        }}
      />
    </section>
  );
}
