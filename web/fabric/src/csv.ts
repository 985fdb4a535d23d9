/** Tables as text (RFC 4180): commas, semicolons or tabs between cells, cells in quotation marks where they hold these. */

interface Row {
  readonly cells: readonly string[];
  /** Its line in the text, from 1. */
  readonly line: number;
}

/** Rows that are not empty, and lines that begin with "# ": a cell may begin with "#20305c". */
export function csvRows(text: string, unclosed: (line: number) => Error): { rows: Row[]; comments: string[] } {
  const separator = separatorOf(text);
  const rows: Row[] = [];
  const comments: string[] = [];
  let cells: string[] = [];
  let cell = "";
  let line = 1;
  let start = 1;
  const endCell = (): void => {
    cells.push(cell.trim());
    cell = "";
  };
  const endRow = (): void => {
    endCell();
    if (/^# /.test(cells[0]!)) comments.push(cells.join(" "));
    else if (cells.some((each) => each !== "")) rows.push({ cells, line: start });
    cells = [];
    start = line + 1;
  };
  for (let at = 0; at < text.length; at++) {
    const sign = text[at]!;
    if (sign === '"' && cell.trim() === "") {
      const opened = line;
      cell = "";
      for (at++; ; at++) {
        if (at >= text.length) throw unclosed(opened);
        if (text[at] === "\n") line++;
        if (text[at] === '"' && text[at + 1] === '"') at++;
        else if (text[at] === '"') break;
        cell += text[at];
      }
    } else if (sign === separator) endCell();
    else if (sign === "\n" || (sign === "\r" && text[at + 1] !== "\n")) {
      endRow();
      line++;
      start = line;
    } else if (sign !== "\r") cell += sign;
  }
  endRow();
  return { rows, comments };
}

/** The sign between cells: the first of tab, semicolon and comma that the text has outside of quotation marks and comments. */
function separatorOf(text: string): string {
  const plain = text.replace(/"[^"]*"/g, "").replace(/^# .*$/gm, "");
  return ["\t", ";", ","].find((sign) => plain.includes(sign)) ?? ",";
}
