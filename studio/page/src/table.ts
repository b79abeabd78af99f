// CSV as the program writes it: one line of titles, numbers, "nan" where there is none; lines with # above it are remarks.

export class Table {
  readonly titles: string[];
  private readonly columns: Float64Array[];

  constructor(text: string) {
    const lines = text.split("\n").filter((line) => line && !line.startsWith("#"));
    this.titles = (lines[0] ?? "").split(",").map((title) => title.trim());
    this.columns = this.titles.map(() => new Float64Array(Math.max(0, lines.length - 1)));
    for (let row = 1; row < lines.length; ++row) {
      const cells = lines[row]!.split(",");
      for (let column = 0; column < this.columns.length; ++column) {
        const cell = cells[column];
        this.columns[column]![row - 1] = cell === undefined || cell === "" || cell === "nan" ? NaN : Number(cell);
      }
    }
  }
  get rows(): number {
    return this.columns[0]?.length ?? 0;
  }
  /** The column of this title, with or without its unit in brackets; null if there is none. */
  column(name: string): Float64Array | null {
    const at = this.titles.findIndex((title) => title === name || title.replace(/ \[[^\]]*\]$/, "") === name);
    return at < 0 ? null : this.columns[at]!;
  }
  at(index: number): Float64Array {
    return this.columns[index] ?? new Float64Array(0);
  }
  /** Of a title such as "force [mN]": "mN"; empty without one. */
  unitOf(index: number): string {
    return / \[([^\]]*)\]$/.exec(this.titles[index] ?? "")?.[1] ?? "";
  }
}
