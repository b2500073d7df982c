// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// Pairs for all methods, made by the program.
import { run } from "./native.js";

/** [source, target, method] */
export const pairs = [
  ["body.ply", "posed.ply", "auto"],
  ["body.ply", "posed.ply", "exact"],
  ["posed.ply", "body.ply", "frontiers"],
  ["body.ply", "remeshed.ply", "auto"],
  ["body.ply", "warped.ply", "spectral"],
  ["remeshed.ply", "posed.ply", "spectral"],
  ["cut.ply", "body.ply", "partial"],
  ["holes.ply", "body.ply", "auto"],
  ["body.ply", "retopology.ply", "place"],
  ["body.ply", "warped.ply", "nearest"],
  ["small.ply", "other_small.ply", "assignment"],
];

export function makePairs() {
  const deformed = (name, ...options) => run("deform", "body.ply", name, ...options);
  run("deform", "body", "body.ply", "--subdivisions", "2");
  run("deform", "body", "small.ply", "--subdivisions", "1");
  deformed("posed.ply", "--bend", "60", "--twist", "20", "--shuffle", "3", "--move");
  deformed("remeshed.ply", "--bend", "40", "--retriangulate", "0.7", "--shuffle", "4");
  deformed("warped.ply", "--warp", "0.03", "--retriangulate", "0.5", "--shuffle", "5", "--move");
  deformed("cut.ply", "--bend", "30", "--cut", "0.4", "--retriangulate", "0.8", "--shuffle", "6");
  deformed("holes.ply", "--twist", "30", "--holes", "4", "--shuffle", "7");
  deformed("retopology.ply", "--retriangulate", "0.9", "--shuffle", "9");
  run("deform", "small.ply", "other_small.ply", "--twist", "10", "--shuffle", "8");
}
