// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
const reloaded = "counterpart: loaded again";

/** Threads share memory only in a page that its headers isolate from others. Where the server sends none, the page's service
 * worker does, from the next load on: loads the page again, once, if `mayReload`. Without it one thread does all. */
export async function isolate(mayReload: () => boolean): Promise<void> {
  if (window.crossOriginIsolated || !("serviceWorker" in navigator)) return;
  try {
    if (sessionStorage.getItem(reloaded)) return;
    await navigator.serviceWorker.register("service_worker.js");
    // It may come to nothing without a word.
    const late = new Promise<null>((resolve) => setTimeout(resolve, 3000, null));
    if (!(await Promise.race([navigator.serviceWorker.ready, late])) || !mayReload()) return;
    sessionStorage.setItem(reloaded, "yes");
  } catch {
    return; // a browser may forbid either
  }
  location.reload();
  await new Promise(() => {});
}
