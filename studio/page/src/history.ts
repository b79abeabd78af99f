// Undo and redo: states as they were before each change.

export class History<State> {
  private readonly past: State[] = [];
  private future: State[] = [];
  private static readonly most = 200;

  /** Remembers the state before a change. */
  push(before: State): void {
    this.past.push(before);
    if (this.past.length > History.most) this.past.shift();
    this.future = [];
  }
  undo(now: State): State | null {
    const state = this.past.pop();
    if (state === undefined) return null;
    this.future.push(now);
    return state;
  }
  redo(now: State): State | null {
    const state = this.future.pop();
    if (state === undefined) return null;
    this.past.push(now);
    return state;
  }
  get canUndo(): boolean {
    return this.past.length > 0;
  }
  get canRedo(): boolean {
    return this.future.length > 0;
  }
}
