// Tells the server which tabs can be seen: viser keeps that to itself. A tab that was never opened
// has no mark in the document, and one behind another has a mark that takes no place.
(() => {
  const CARRIER = "$carrier";
  let told = "$told";
  window.__singulateSight?.abort();
  window.__singulateSight = new AbortController();
  const { signal } = window.__singulateSight;

  const look = () => {
    const marks = [...document.querySelectorAll("[data-singulate-tab]")];
    const seen = marks.filter((mark) => mark.getClientRects().length > 0);
    const names = document.hidden ? [] : ["table", ...seen.map((mark) => mark.dataset.singulateTab)];
    const text = names.join(" ");
    if (text === told) return;
    told = text;
    window.__viserMutable.sendMessage(
      { type: "GuiUpdateMessage", uuid: CARRIER, updates: { value: text } });
  };

  const timer = setInterval(look, $interval_ms);
  signal.addEventListener("abort", () => clearInterval(timer));
  document.addEventListener("visibilitychange", look, { signal });
  window.addEventListener("click", () => requestAnimationFrame(look), { signal });
})();
