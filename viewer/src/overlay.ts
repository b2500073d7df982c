// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { ScreenPoint } from "./stage";

export interface Line {
  from: ScreenPoint;
  to: ScreenPoint;
  color: string;
}
export interface Marker {
  at: ScreenPoint;
  color: string;
  /** A ring marks the true image; a disc the image under the map. */
  shape: "disc" | "ring";
}

/** Lines and markers over both meshes. */
export class Overlay {
  private readonly context: CanvasRenderingContext2D;

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.context = canvas.getContext("2d")!;
  }

  resize(): void {
    const scale = Math.min(window.devicePixelRatio, 2);
    this.canvas.width = this.canvas.clientWidth * scale;
    this.canvas.height = this.canvas.clientHeight * scale;
    this.context.setTransform(scale, 0, 0, scale, 0, 0);
  }

  draw(lines: Line[], link: Line | null, markers: Marker[]): void {
    const { context } = this;
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.lineCap = "round";
    for (const line of lines) {
      // Pairs on the far side stay visible, but do not hide the near ones.
      context.globalAlpha = line.from.facing && line.to.facing ? 0.85 : 0.16;
      this.stroke(line, 1.2);
      this.dot(line.from, 2, line.color);
      this.dot(line.to, 2, line.color);
    }
    context.globalAlpha = 1;
    if (link) {
      context.setLineDash([5, 5]);
      this.stroke(link, 1.5);
      context.setLineDash([]);
    }
    for (const marker of markers) this.mark(marker);
  }

  private stroke(line: Line, width: number): void {
    this.context.strokeStyle = line.color;
    this.context.lineWidth = width;
    this.context.beginPath();
    this.context.moveTo(line.from.x, line.from.y);
    this.context.lineTo(line.to.x, line.to.y);
    this.context.stroke();
  }

  private dot(at: ScreenPoint, radius: number, color: string): void {
    this.context.fillStyle = color;
    this.context.beginPath();
    this.context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
    this.context.fill();
  }

  /** Outlined in white and black, so that it is visible on every color; hollow where the surface faces away. */
  private mark({ at, color, shape }: Marker): void {
    const { context } = this;
    const radius = shape === "ring" ? 11 : 6.5;
    context.beginPath();
    context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
    if (shape === "disc") {
      context.fillStyle = color;
      context.globalAlpha = at.facing ? 1 : 0.35;
      context.fill();
      context.globalAlpha = 1;
    }
    const outline = shape === "disc" ? [["#000000", 4.5], ["#ffffff", 2.2]] as const : [["#000000", 4.5], [color, 2.4]] as const;
    for (const [style, width] of outline) {
      context.strokeStyle = style;
      context.lineWidth = width;
      context.stroke();
    }
  }
}
