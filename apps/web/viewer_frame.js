// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// Makes viewer.html, which the page shows in a frame, of the viewer's own: scripts and styles are files here, so that its
// policy allows no others.
import { readFileSync, writeFileSync } from "node:fs";

const replaced = [
  [
    "script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:",
    "script-src 'self'; style-src 'self'; img-src data: blob:",
  ],
  ['<script type="module" src="/src/main.ts"></script>', '<script type="module" src="/src/frame.ts"></script>'],
  ["    <!--counterpart-data-->\n", ""],
];
let page = readFileSync(new URL("../../viewer/index.html", import.meta.url), "utf8");
for (const [before, after] of replaced) {
  if (!page.includes(before)) throw new Error(`viewer/index.html has no ${before}`);
  page = page.replace(before, () => after);
}
writeFileSync(new URL("viewer.html", import.meta.url), page);
