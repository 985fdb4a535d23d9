/** Which parts of the page fail at present. */

export class Health {
  private readonly failing = new Set<string>();
  private readonly onFault: (part: string, error: unknown) => void;

  /** @param onFault is called when a part fails that did not. */
  constructor(onFault: (part: string, error: unknown) => void) {
    this.onFault = onFault;
  }

  get isWell(): boolean {
    return this.failing.size === 0;
  }

  failed(part: string, error: unknown): void {
    if (this.failing.has(part)) return;
    this.failing.add(part);
    this.onFault(part, error);
  }

  recovered(part: string): void {
    this.failing.delete(part);
  }
}
