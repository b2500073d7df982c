// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { Selection } from "./modes";

/** Pairs of vertices that a person says correspond. */
export class Landmarks {
  pairs: [number, number][] = [];
  private source: number | null = null;

  /** A vertex of the source, then one of the target, are a pair. */
  pick({ side, vertex }: Selection): void {
    if (side === "source") {
      this.source = vertex;
    } else if (this.source !== null) {
      this.pairs.push([this.source, vertex]);
      this.source = null;
    }
  }

  /** Forgets a vertex of the source that waits for its counterpart. */
  stop(): void {
    this.source = null;
  }

  get isWaiting(): boolean {
    return this.source !== null;
  }

  clear(): void {
    this.pairs = [];
  }

  /** Downloads them as `counterpart match --landmarks` reads them. */
  save(): void {
    const lines = this.pairs.map(([source, target]) => `${source} ${target}\n`);
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob(lines, { type: "text/plain" }));
    link.download = "landmarks.txt";
    link.click();
    URL.revokeObjectURL(link.href);
  }
}
