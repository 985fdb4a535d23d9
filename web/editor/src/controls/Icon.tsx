/** Line icons, 20 units a side. */
const PATHS = {
  undo: "M8 5 4 9l4 4M4 9h8a4 4 0 0 1 0 8h-2",
  redo: "m12 5 4 4-4 4m4-4H8a4 4 0 0 0 0 8h2",
  open: "M3 16V5h5l2 2h7v9z",
  save: "M10 3v9m-4-3.5L10 12l4-3.5M4 16h12",
  link: "M8.5 11.5a3 3 0 0 0 4.2 0l2.6-2.6a3 3 0 0 0-4.2-4.2l-1 1m1.4 2.8a3 3 0 0 0-4.2 0l-2.6 2.6a3 3 0 0 0 4.2 4.2l1-1",
  compare: "M10 3v14M3.5 5.5h4v9h-4zM12.5 5.5h4v9h-4z",
  close: "m5 5 10 10M15 5 5 15",
  camera: "M3 6.5h3.5L8 4.5h4l1.5 2H17v9H3zM10 8a3 3 0 1 0 0 6 3 3 0 0 0 0-6",
  frame: "M4 8V4h4m4 0h4v4m0 4v4h-4m-4 0H4v-4",
  plus: "M10 4v12M4 10h12",
  minus: "M4 10h12",
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name }: { readonly name: IconName }) {
  return (
    <svg class="icon" viewBox="0 0 20 20" aria-hidden="true">
      <path d={PATHS[name]} />
    </svg>
  );
}
