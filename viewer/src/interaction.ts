// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import { homeView, type Stage, type View } from "./stage";

export interface InteractionEvents {
  viewChanged(): void;
  hover(x: number, y: number): void;
  leave(): void;
  select(x: number, y: number): void;
  release(): void;
}

const dragThreshold = 5; // pixels of movement that still count as a click

/** Rotating, panning and zooming by mouse, touch and keyboard; hovering and selecting. */
export class Interaction {
  linked = true;
  private readonly pointers = new Map<number, { x: number; y: number }>();
  private pane = 0;
  private traveled = 0;

  constructor(
    private readonly stage: Stage,
    private readonly events: InteractionEvents,
  ) {
    const { canvas } = stage;
    canvas.addEventListener("pointerdown", (event) => this.down(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.up(event));
    canvas.addEventListener("pointercancel", (event) => this.pointers.delete(event.pointerId));
    canvas.addEventListener("pointerleave", () => events.leave());
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("dblclick", () => this.reset());
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  reset(): void {
    Object.assign(this.stage.views.source, homeView());
    Object.assign(this.stage.views.target, homeView());
    this.events.viewChanged();
  }

  private change(apply: (view: View) => void): void {
    if (this.linked) for (const view of Object.values(this.stage.views)) apply(view);
    else apply(this.stage.viewOf(this.pane));
    this.events.viewChanged();
  }

  private turn(dx: number, dy: number): void {
    this.change((view) => {
      view.yaw += dx;
      view.pitch = Math.min(Math.max(view.pitch + dy, -Math.PI / 2), Math.PI / 2);
    });
  }

  private shift(dx: number, dy: number): void {
    const units = this.stage.unitsPerPixel(this.pane);
    this.change((view) => {
      view.x = Math.min(Math.max(view.x - dx * units, -1.5), 1.5);
      view.y = Math.min(Math.max(view.y + dy * units, -1.5), 1.5);
    });
  }

  private zoom(factor: number): void {
    this.change((view) => {
      view.zoom = Math.min(Math.max(view.zoom * factor, 0.3), 60);
    });
  }

  private down(event: PointerEvent): void {
    const point = local(event);
    if (this.pointers.size === 0) {
      this.pane = this.stage.paneAt(point.x, point.y);
      this.traveled = 0;
    }
    this.pointers.set(event.pointerId, point);
    this.stage.canvas.setPointerCapture(event.pointerId);
  }

  private move(event: PointerEvent): void {
    const now = local(event);
    const before = this.pointers.get(event.pointerId);
    if (!before) {
      if (event.pointerType !== "touch") this.events.hover(now.x, now.y);
      return;
    }
    const dx = now.x - before.x;
    const dy = now.y - before.y;
    this.traveled += Math.hypot(dx, dy);
    if (this.pointers.size === 2) {
      const other = [...this.pointers].find(([id]) => id !== event.pointerId)![1];
      const length = (p: { x: number; y: number }) => Math.hypot(p.x - other.x, p.y - other.y);
      this.zoom(length(now) / Math.max(1, length(before)));
      this.shift(dx / 2, dy / 2);
    } else if (this.traveled > dragThreshold) {
      const isShift = event.shiftKey || (event.buttons & 6) !== 0;
      if (isShift) this.shift(dx, dy);
      else this.turn(0.008 * dx, 0.008 * dy);
    }
    this.pointers.set(event.pointerId, now);
  }

  private up(event: PointerEvent): void {
    const alone = this.pointers.size === 1;
    if (!this.pointers.delete(event.pointerId)) return;
    const { x, y } = local(event);
    if (alone && this.traveled <= dragThreshold && event.button === 0) this.events.select(x, y);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const { x, y } = local(event);
    this.pane = this.stage.paneAt(x, y);
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 20 : 1;
    this.zoom(Math.exp(-0.0015 * lines * event.deltaY));
  }

  private key(event: KeyboardEvent): void {
    const arrows: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, -1],
      ArrowDown: [0, 1],
    };
    const arrow = arrows[event.key];
    if (arrow && event.shiftKey) this.shift(24 * arrow[0], 24 * arrow[1]);
    else if (arrow) this.turn(0.12 * arrow[0], 0.12 * arrow[1]);
    else if (event.key === "+" || event.key === "=") this.zoom(1.15);
    else if (event.key === "-") this.zoom(1 / 1.15);
    else if (event.key === "0" || event.key === "Home") this.reset();
    else if (event.key === "Escape") this.events.release();
    else return;
    event.preventDefault();
  }
}

function local(event: MouseEvent): { x: number; y: number } {
  return { x: event.offsetX, y: event.offsetY };
}
