// The picture viewer: any picture of any run, alone or beside another with a wipe or in turns; frames, zoom, pixels.
const kindTexts = { frame: "frame", full: "full render", decision: "decision", class: "hit class", threshold: "threshold", difference: "difference", error: "error", cycles: "cycles a pixel" };

/** sources: [{label, width, pictures: [{kind, frame, png}]}] */
function pictureViewer(sources) {
  const store = sources.map((source) => {
    const kinds = new Map();
    for (const p of source.pictures) {
      if (!kinds.has(p.kind)) kinds.set(p.kind, new Map());
      kinds.get(p.kind).set(p.frame, p.png);
    }
    return kinds;
  });
  const frames = [...new Set(sources.flatMap((source) => source.pictures.map((p) => p.frame)))].sort((a, b) => a - b);
  const kinds = Object.keys(kindTexts).filter((kind) => store.some((source) => source.has(kind)));
  const first = store.findIndex((source) => source.size);
  const several = sources.length > 1;
  const state = { frame: 0, a: { source: first, kind: kinds[0] }, b: null, zoom: "fit", wipe: 50, turns: false };

  const lower = h("img", { alt: "" }), upper = h("img", { alt: "", class: "over hidden" }), line = h("div", { class: "wipe hidden" });
  const holder = h("div", { class: "pictures" }, lower, upper, line);
  const stage = h("div", { class: "stage", tabindex: 0, role: "group", "aria-label": "Picture. Left and right: frames; up and down: kind of picture; plus and minus: zoom" }, holder);
  const readout = h("span", { class: "soft mono", id: "pixel" }, " "), caption = h("span", { role: "status", id: "picture-caption" });
  const png = (place) => store[place.source].get(place.kind)?.get(frames[state.frame]);
  const name = (place) => (several ? sources[place.source].label + ", " : "") + kindTexts[place.kind];

  const buttons = kinds.map((kind, i) => h("button", { type: "button", "data-kind": kind, onclick: () => { state.a.kind = kind; if (several && state.b) state.b.kind = kind; show(); } }, kindTexts[kind]));
  const slider = h("input", { type: "range", id: "frame", min: 0, max: Math.max(0, frames.length - 1), value: 0, "aria-label": "Frame" });
  slider.addEventListener("input", () => { state.frame = Number(slider.value); show(); });
  const step = (by) => { state.frame = Math.max(0, Math.min(frames.length - 1, state.frame + by)); show(); };
  const zooms = ["fit", "1", "2", "4", "8", "16"];
  const zoom = choice("zoom", zooms.map((z) => [z, z === "fit" ? "to fit" : z + "×"]), "fit", (z) => { state.zoom = z; show(); });
  const places = sources.flatMap((source, i) => kinds.filter((kind) => store[i].has(kind)).map((kind) => ({ source: i, kind })));
  const beside = choice("against", [["", "nothing"], ...places.map((place, i) => [String(i), name(place)])], "", (i) => { state.b = i === "" ? null : { ...places[Number(i)] }; show(); });
  const which = choice("of", sources.map((source, i) => [String(i), source.label]), String(first), (i) => { state.a.source = Number(i); show(); });
  const wipe = h("input", { type: "range", id: "wipe", min: 0, max: 100, value: 50, "aria-label": "How much of the first picture" });
  wipe.addEventListener("input", () => { state.wipe = Number(wipe.value); show(); });
  const turns = h("input", { type: "checkbox", id: "turns" });
  let timer = null, second = false;
  turns.addEventListener("change", () => {
    state.turns = turns.checked;
    clearInterval(timer);
    if (state.turns) timer = setInterval(() => { second = !second; show(); }, 600);
    show();
  });
  const comparing = h("div", { class: "bar hidden" }, h("label", { style: { flex: "1 1 12rem" } }, h("span", {}, "wipe"), wipe), h("label", {}, turns, h("span", {}, "in turns")));

  function sized(img) {
    const unit = sources[state.a.source].width, room = Math.max(60, stage.clientWidth);
    const factor = state.zoom === "fit" ? room / Math.max(unit, lower.naturalWidth || unit) : Number(state.zoom);
    img.style.width = (img.naturalWidth || unit) * factor + "px";
    return factor;
  }
  function show() {
    buttons.forEach((b) => b.setAttribute("aria-pressed", String(b.dataset.kind === state.a.kind)));
    slider.value = state.frame;
    zoom.select.value = state.zoom;
    beside.select.value = state.b === null ? "" : String(places.findIndex((p) => p.source === state.b.source && p.kind === state.b.kind));
    const a = png(state.a), b = state.b && png(state.b);
    caption.textContent = `frame ${frames[state.frame]}: ${name(state.a)}${a ? "" : " (this run has no such picture)"}${state.b ? " | " + name(state.b) + (b ? "" : " (no such picture)") : ""}`;
    const put = (img, data) => { const url = data ? "data:image/png;base64," + data : ""; if (img.getAttribute("src") !== url) { if (url) img.src = url; else img.removeAttribute("src"); } };
    put(lower, b && !state.turns ? b : a);
    lower.classList.toggle("hidden", !(b && !state.turns ? b : a));
    lower.alt = name(state.a);
    if (b) { put(upper, state.turns ? b : a); upper.alt = name(state.turns ? state.b : state.a); }
    upper.classList.toggle("hidden", !b || !a || (state.turns && !second));
    line.classList.toggle("hidden", !b || state.turns);
    upper.style.clipPath = b && !state.turns ? `inset(0 ${100 - state.wipe}% 0 0)` : "none";
    comparing.classList.toggle("hidden", !state.b);
    fit();
  }
  function fit() {
    sized(lower); sized(upper);
    line.style.left = (state.wipe / 100) * (parseFloat(upper.style.width) || 0) + "px";
  }
  lower.addEventListener("load", fit); upper.addEventListener("load", fit);
  new ResizeObserver(fit).observe(stage);

  stage.addEventListener("keydown", (e) => {
    if (e.altKey || e.ctrlKey || e.metaKey) return;
    const kind = (by) => { state.a.kind = kinds[(kinds.indexOf(state.a.kind) + by + kinds.length) % kinds.length]; show(); };
    const zoomBy = (by) => { state.zoom = zooms[Math.max(0, Math.min(zooms.length - 1, zooms.indexOf(state.zoom) + by))]; show(); };
    const pan = { ArrowLeft: [-40, 0], ArrowRight: [40, 0], ArrowUp: [0, -40], ArrowDown: [0, 40] }[e.key];
    const act = { ArrowLeft: () => step(-1), ArrowRight: () => step(1), ArrowUp: () => kind(-1), ArrowDown: () => kind(1), "+": () => zoomBy(1), "=": () => zoomBy(1), "-": () => zoomBy(-1), Home: () => step(-1e9), End: () => step(1e9) }[e.key];
    if (!act) return;
    e.preventDefault();
    if (e.shiftKey && pan) stage.scrollBy(...pan); else act();
  });

  // The colour of the pixel that is pointed at, from the picture itself.
  const canvas = h("canvas"), context = canvas.getContext("2d", { willReadFrequently: true });
  let drawn = null;
  holder.addEventListener("pointermove", (e) => {
    const box = lower.getBoundingClientRect(), factor = box.width / (lower.naturalWidth || 1);
    const x = Math.floor((e.clientX - box.left) / factor), y = Math.floor((e.clientY - box.top) / factor);
    if (!lower.naturalWidth || x < 0 || y < 0 || x >= lower.naturalWidth || y >= lower.naturalHeight) return;
    if (drawn !== lower.src) { canvas.width = lower.naturalWidth; canvas.height = lower.naturalHeight; context.drawImage(lower, 0, 0); drawn = lower.src; }
    const [r, g, b] = context.getImageData(x, y, 1, 1).data;
    readout.textContent = `(${x}, ${y}) = ${r} ${g} ${b}`;
  });

  const element = h("div", { id: "viewer" },
    h("div", { class: "bar", role: "group", "aria-label": "Kind of picture" }, several && which.element, buttons),
    h("div", { class: "bar" },
      h("button", { type: "button", "aria-label": "Frame before", onclick: () => step(-1) }, "◀"), slider,
      h("button", { type: "button", "aria-label": "Next frame", onclick: () => step(1) }, "▶"), zoom.element, beside.element),
    comparing, h("div", { class: "bar" }, caption, readout), stage);
  element.compare = (a, b) => { state.a = a; state.b = b; which.select.value = String(a.source); show(); };
  show();
  return element;
}
