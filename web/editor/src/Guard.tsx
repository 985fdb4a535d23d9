/** Holds the page up where one part of it fails: says which, and offers ways on. */
import { messageOf } from "loomlight-fabric";
import { Component, type ComponentChildren } from "preact";

import { saveFabric } from "./files.ts";
import type { Health } from "./health.ts";
import type { Store } from "./state/store.ts";

interface Props {
  /** What the part is called in a sentence: "yarns panel". */
  readonly part: string;
  readonly store: Store;
  readonly health: Health;
  /** A part that failed is tried again when this changes. */
  readonly shown: unknown;
  readonly children: ComponentChildren;
}

export class Guard extends Component<Props, { readonly fault: unknown }> {
  override state: { readonly fault: unknown } = { fault: null };

  override componentDidCatch(error: unknown): void {
    this.setState({ fault: error ?? new Error("no reason was given") });
    this.props.health.failed(this.props.part, error);
  }

  override componentDidUpdate(before: Props): void {
    if (this.state.fault !== null && before.shown !== this.props.shown) this.tryAgain();
  }

  override componentWillUnmount(): void {
    this.props.health.recovered(this.props.part);
  }

  private tryAgain(): void {
    this.props.health.recovered(this.props.part);
    this.setState({ fault: null });
  }

  private save(): void {
    saveFabric(this.props.store.state.fabric).catch((error: unknown) => this.setState({ fault: error }));
  }

  override render({ part, store, children }: Props) {
    const { fault } = this.state;
    if (fault === null) return children;
    const text = messageOf(fault);
    return (
      <div class="guard" role="alert" data-testid="guard">
        <h2>The {part} cannot be shown</h2>
        <p>{text}</p>
        <p>Your cloth is kept, and the rest of the page works.</p>
        <div class="row">
          {store.state.history.past.length > 0 && (
            <button type="button" class="button is-primary" data-testid="guard-undo" onClick={() => store.dispatch({ type: "history/undo" })}>
              Undo the last change
            </button>
          )}
          <button type="button" class="button" data-testid="guard-again" onClick={() => this.tryAgain()}>
            Try again
          </button>
          <button type="button" class="button" data-testid="guard-save" onClick={() => this.save()}>
            Save the fabric
          </button>
        </div>
      </div>
    );
  }
}
