// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import { defineConfig } from "vite";

// One page that needs nothing else: script and style go into the HTML. The mark stays: `counterpart view` puts the
// meshes there.
function singleFile() {
  return {
    name: "single-file",
    enforce: "post",
    generateBundle(_options, bundle) {
      const page = bundle["index.html"];
      for (const [name, item] of Object.entries(bundle)) {
        if (name.endsWith(".js")) {
          // "</script" would end the element; the escape means the same inside JavaScript strings.
          const code = item.code.trim().replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
          page.source = page.source.replace(/<script type="module"[^>]*><\/script>\s*/, "");
          page.source = page.source.replace("</body>", () => `<script type="module">${code}</script>\n</body>`);
        } else if (name.endsWith(".css")) {
          page.source = page.source.replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${item.source.trim()}</style>`);
        } else {
          continue;
        }
        delete bundle[name];
      }
      page.fileName = "viewer.html";
    },
  };
}

export default defineConfig({
  plugins: [singleFile()],
  build: { target: "es2022", modulePreload: false, cssCodeSplit: false, assetsInlineLimit: 0 },
});
