// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { Correspondence } from "./correspondence";
import type { Selection } from "./modes";
import { errorStops, gradient, levelStops, missingColor } from "./palette";
import type { MapData, SceneData } from "./scene_data";
import type { Values } from "./values";

type Content = string | Node;

function tag(name: string, className: string, ...content: Content[]): HTMLElement {
  const node = document.createElement(name);
  if (className) node.className = className;
  node.append(...content);
  return node;
}

export function formatError(error: number): string {
  if (error === 0) return "exact";
  return Number.isFinite(error) ? `error ${error.toFixed(2)} % of √area` : "on another component";
}

/** The text about a map: the verdict first. */
export function summarize(correspondence: Correspondence): Content[] {
  const { verdict } = correspondence.map;
  return verdict ? [tag("b", "verdict", verdict), ` · ${correspondence.summary()}`] : [correspondence.summary()];
}

/** The text about the selected vertex: for the current map first, then for the others. */
export function describe(
  selection: Selection | null,
  current: Correspondence,
  all: Correspondence[],
  scene: SceneData,
): Content[] {
  if (!selection) return ["Hover or tap a vertex on either mesh."];
  if (selection.side === "target") return describeTarget(selection.vertex, current);
  const source = selection.vertex;
  const content: Content[] = [tag("span", "", "→ target vertex ", imageOf(current, source))];
  content.push(tag("span", "error", truthOf(current, source, scene)));
  const confidence = current.map.confidence?.[source] ?? NaN;
  if (!Number.isNaN(confidence)) content.push(tag("span", "error", `confidence ${confidence.toFixed(2)}`));
  for (const other of all) {
    if (other === current) continue;
    const error = other.map.error?.[source] ?? NaN;
    const known = Number.isNaN(error) ? "" : ` (${formatError(error)})`;
    content.push(tag("span", "others", `${other.map.name}: `, imageOf(other, source), known));
  }
  return content;
}

function imageOf(correspondence: Correspondence, source: number): HTMLElement {
  const image = correspondence.map.image[source];
  return tag("b", "", image < 0 ? "none" : String(image));
}

function truthOf({ map }: Correspondence, source: number, scene: SceneData): string {
  const error = map.error?.[source] ?? NaN;
  const truth = scene.truth?.[source] ?? -1;
  if (Number.isNaN(error)) return scene.truth && truth < 0 ? "no known truth" : truth >= 0 ? `truth ${truth}` : "";
  return error === 0 ? "exact" : `${formatError(error)} · truth ${truth}`;
}

function describeTarget(target: number, current: Correspondence): Content[] {
  const sources = current.sourcesOf(target);
  const name = tag("span", "", "Target vertex ", tag("b", "", String(target)));
  if (sources.length === 0) return [name, tag("span", "error", "no source vertex maps here")];
  const from = tag("span", "", " ← source vertex ", tag("b", "", String(sources[0])));
  const content: Content[] = [name, from];
  if (sources.length > 1) content.push(tag("span", "error", `and ${sources.length - 1} more`));
  const error = current.map.error?.[sources[0]] ?? NaN;
  if (!Number.isNaN(error)) content.push(tag("span", "error", formatError(error)));
  return content;
}

function bar(title: string, stops: string[], low: string, high: string): Content[] {
  const strip = tag("div", "bar");
  strip.style.background = gradient(stops);
  return [title, tag("span", "scale", low, strip, high)];
}

function missing(text: string): HTMLElement {
  const swatch = tag("span", "swatch");
  swatch.style.background = missingColor;
  return tag("span", "", swatch, text);
}

export function errorLegend(top: number): Content[] {
  return [...bar("Error, % of √area", errorStops, "0", `≥ ${top.toPrecision(2)}`), missing("not known or unmatched")];
}

export function valueLegend({ name, range: [low, high], of }: Values, map: MapData): Content[] {
  if (!of(map)) return [missing(`${name} of this map: not known`)];
  return [...bar(name, levelStops, String(+low.toPrecision(3)), String(+high.toPrecision(3))), missing("not known")];
}

export function levelLegend(base: number, top: number, bandWidth: number): Content[] {
  const title = `Edges from vertex ${base}, bands of ${bandWidth}`;
  return bar(title, levelStops, "0", String(top));
}

export function colorLegend(): Content[] {
  return [missing("no counterpart")];
}
