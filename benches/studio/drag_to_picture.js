// Within the page: notes when the sun's slider moved, and when the section of that question was on the screen.
(() => {
  const moved = new Map();
  const pictures = [];
  let answered = null;
  let heard = () => undefined;
  const plain = window.fetch;
  window.fetch = async (path, how) => {
    const asked = performance.now();
    const answer = await plain(path, how);
    if (!String(path).endsWith("/api/panel/section")) return answer;
    const elevation = JSON.parse(how.body).elevation_deg;
    const json = answer.json.bind(answer);
    answer.json = async () => {
      const told = await json();
      answered = { elevation, asked, got: performance.now() };
      return told;
    };
    return answer;
  };
  document.addEventListener("input", (event) => event.target.id === "elevation" && moved.set(event.target.valueAsNumber, event.timeStamp), true);
  const isBeam = ({ target }) => target.tagName === "path" ? (target.getAttribute("fill") ?? "").startsWith("rgb") : target.hasAttribute("clip-path");
  new MutationObserver((changes) => {
    if (!answered || !changes.some(isBeam)) return;
    const one = { ...answered, moved: moved.get(answered.elevation), drawn: performance.now() };
    answered = null;
    // the frame with the new beams is painted after this callback, and the message comes after that
    requestAnimationFrame(() => {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => {
        pictures.push({ ...one, shown: performance.now() });
        heard();
      };
      port2.postMessage(null);
    });
  }).observe(document, { subtree: true, childList: true, attributeFilter: ["d"] });
  window.drag = {
    /** What was seen since the last time. */
    taken: () => pictures.splice(0),
    /** Ends with the next picture. */
    next: () => new Promise((done) => (heard = done)),
  };
})();
