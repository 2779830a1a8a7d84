// The panels of one run.

const meaning = (run, name) => run.meanings[name] || ["", ""];
const tile = (value, text) => h("div", { class: "tile" }, h("b", {}, value), h("span", {}, text));
const isSampled = (run) => run.manifest.fidelity === "sampled";

function runTitle(run) {
  const m = run.manifest;
  const count = m.frames.last - m.frames.first;
  return `${m.input.file}, ${m.size.width}×${m.size.height}, ` + (count === 1 ? `frame ${m.frames.first}` : `frames ${m.frames.first} to ${m.frames.last - 1}`);
}

/** The figures that one wants to know first: [value, text]. */
function headline(run) {
  const { derived: d, totals: t, energy: e, fidelity } = run.stats, tiles = [];
  const put = (value, text, shown = number) => { if (isNumber(value)) tiles.push([shown(value), text]); };
  put(d.cycles_per_frame, "cycles a frame", (x) => number(Math.round(x)));
  put(d.fps, "frames/s of the unit");
  put(d.mrays_per_second, "Mrays/s");
  put(t.traced_share, "of the pixels ray traced", percent);
  put(d.rays_per_pixel, "rays a pixel");
  put(d.node_visits_per_ray, "node visits a ray");
  put(d.dram_gb_per_second, "GB/s of DRAM traffic");
  if (e) { put(e.frame_uj, "µJ a frame"); put(e.ray_nj, "nJ a ray"); put(e.power_mw, "mW"); }
  tiles.push([fidelity.mode, "fidelity: " + (fidelity.promise || "")]);
  return tiles;
}

function verdicts(run) {
  const list = [], check = run.stats.check;
  const violations = run.stats.frames.flatMap((frame) => frame.violations.map((text) => `frame ${frame.index}: ${text}`));
  if (run.manifest.falsified) list.push(note("bad", "A fault was injected: these are not the unit's figures."));
  if (check) {
    list.push(check.passed ? note("good", `Check passed: all ${number(check.pixels)} pixels and all ray counts are the golden model's.`)
      : note("bad", `Check failed: ${number(check.differing_pixels)} of ${number(check.pixels)} pixels differ from the golden model.`));
    if (check.first && check.first.fields) {
      list.push(h("p", {}, `The first one: frame ${check.first.frame}, pixel (${check.first.x}, ${check.first.y}).`),
        dataTable("The first pixel that differs", [{ key: "field", label: "field" }, { key: "unit", label: "unit" }, { key: "golden", label: "golden model" }, { key: "differs", label: "", text: (r) => (r.differs ? "differs" : "") }],
          Object.entries(check.first.fields).map(([field, f]) => ({ field, ...f }))).element);
    }
  } else list.push(note("", "Not compared with the golden model; ", command("artu run --check"), " does."));
  if (violations.length) list.push(note("bad", `${violations.length} accounting laws are violated:`), h("ul", {}, violations.slice(0, 50).map((v) => h("li", {}, v))));
  else list.push(note("good", "All accounting laws hold."));
  return list;
}

/** The words of `artu explain`. */
function explanation(run) {
  if (!Array.isArray(run.explanation)) return null;
  const at = run.explanation.find(([what]) => what === "bottleneck");
  return [h("h3", {}, "What binds it"), at && note("", at[1]), h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "What binds it" }, h("table", { id: "explanation" }, h("tbody", {}, run.explanation.filter((line) => line !== at).map(([what, text]) => h("tr", {}, h("th", { scope: "row" }, what), h("td", { class: "long" }, text)))))),
    h("p", { class: "soft" }, "In the words of ", command("artu explain"), "; ", command("--verify"), " tries it out.")];
}

function summarySection(run) {
  const estimates = run.stats.totals.estimates;
  return section("summary", "Summary", h("div", { class: "tiles" }, headline(run).map(([value, text]) => tile(value, text))), verdicts(run), explanation(run),
    estimates && Object.keys(estimates).length > 0 && h("details", {}, h("summary", {}, "Estimates with their 95 % intervals"), estimateTable(estimates)));
}
function estimateTable(estimates) {
  const rows = [];
  const walk = (object, path) => {
    for (const [key, value] of Object.entries(object)) {
      if (!value || typeof value !== "object") continue;
      const name = path ? path + "." + key : key;
      if (isNumber(value.value)) rows.push({ name, value: value.value, low: value.low, high: value.high, unit: value.unit });
      else walk(value, key === "blocks" ? "" : name);
    }
  };
  walk(estimates, "");
  return dataTable("Estimates", [{ key: "name", label: "figure", long: true }, ...["value", "low", "high"].map((key) => ({ key, label: key, num: true })), { key: "unit", label: "unit" }], rows, { filter: true, limit: 50, tall: true }).element;
}

function picturesSection(run) {
  if (!run.pictures.length) return section("pictures", "Pictures", note("", "The run has none; ", command("artu run --pictures all"), " writes all there are."));
  const missing = Object.keys(kindTexts).filter((kind) => !run.pictures.some((p) => p.kind === kind));
  return section("pictures", "Pictures", pictureViewer([{ label: run.name, width: run.manifest.size.width, pictures: run.pictures }]),
    missing.length > 0 && h("p", { class: "soft" }, `Not in this run: ${missing.map((kind) => kindTexts[kind]).join(", ")}; `, command("--pictures all"), " has them."),
    run.frames_left_out > 0 && h("p", { class: "soft" }, `The pictures of ${run.frames_left_out} frames are left out; `, command("artu report --picture-megabytes"), " has more."));
}

function framesSection(run) {
  const frames = run.stats.frames;
  if (frames.length < 2) return null;
  const figures = [["cycles", (f) => f.cycles, "cycles"], ["rays", (f) => sum(Object.values(f.rays)), "rays"], ["node visits", (f) => f.node_visits, "nodes"], ["triangle tests", (f) => f.triangle_tests, "triangles"],
    ["ray-traced share", (f) => f.traced_share, ""], ["DRAM bytes", (f) => f.dram && f.dram.read_bytes + f.dram.write_bytes, "bytes"], ["energy", (f) => f.energy && f.energy.frame_uj, "µJ"]].filter(([, of]) => isNumber(of(frames[0])));
  let chosen = figures[0];
  const line = () => [{ name: chosen[0], fill: "var(--s0)", points: frames.map((f) => [f.index, chosen[1](f)]).filter((p) => isNumber(p[1])) }];
  const place = h("div"), y = { label: "" };
  const draw = () => { y.label = chosen[0] + (chosen[2] && chosen[2] !== chosen[0] ? ` (${chosen[2]})` : ""); clear(place).append(lineChart("By frame", line, { x: { label: "frame" }, y })); };
  draw();
  const pick = choice("figure", figures.map(([name], i) => [String(i), name]), "0", (i) => { chosen = figures[Number(i)]; draw(); });
  return section("frames", "By frame", h("div", { class: "bar" }, pick.element), place);
}

function memorySection(run) {
  const groups = grouped(run.stats.totals.blocks), dram = run.stats.totals.blocks.dram, caches = [...groups].filter(([, g]) => g.counters.hits !== undefined && g.counters.misses !== undefined);
  if (!caches.length) return null;
  const parts = (c) => [{ name: "hits", value: c.hits, fill: "var(--s2)" }, { name: "merged misses", value: c.merged_misses || 0, fill: "var(--s4)" }, { name: "misses", value: Math.max(0, c.misses - (c.merged_misses || 0)), fill: "var(--s1)" }];
  const rows = caches.map(([name, g]) => ({ label: name + (g.count > 1 ? ` ×${g.count}` : ""), parts: parts(g.counters), total: g.counters.hits + g.counters.misses, value: percent(ratio(g.counters.hits, g.counters.hits + g.counters.misses)) }));
  const size = (name) => (run.parameters.find((p) => p[0] === `${name}.size` || p[0] === `memory.${name}.size` || p[0] === `selective.${name}.size`) || [])[1];
  const table = caches.map(([name, g]) => ({ name, count: g.count, size: size(name), requests: g.counters.hits + g.counters.misses, rate: ratio(g.counters.hits, g.counters.hits + g.counters.misses), merged: g.counters.merged_misses, fills: g.counters.fills, backs: g.counters.write_backs }));
  const element = h("div", {}, h("h3", {}, "Caches"),
    h("p", { class: "soft" }, "A merged miss is on a line that is already on its way. The number is the share of hits."),
    legend([["hits", "var(--s2)"], ["merged misses", "var(--s4)"], ["misses", "var(--s1)"]]), stackChart("Hits and misses of each cache", rows),
    h("details", {}, h("summary", {}, "As a table"), dataTable("Caches", [{ key: "name", label: "cache" }, { key: "count", label: "number", num: true }, { key: "size", label: "size in bytes (of a core's, or of all banks)", num: true }, { key: "requests", label: "requests", num: true }, { key: "rate", label: "hits", num: true, text: (r) => percent(r.rate) }, { key: "merged", label: "merged misses", num: true }, { key: "fills", label: "fills in lines", num: true }, { key: "backs", label: "write-backs in lines", num: true }], table).element));
  return section("memory", "Caches and DRAM", element, dram && dramPanel(run, dram));
}
function dramPanel(run, dram) {
  const clocks = sum(states.map((state) => dram[state] || 0)), accesses = dram.row_hits + dram.row_misses + dram.row_empty;
  if (!isNumber(accesses)) return null;
  const channels = Number((run.parameters.find((p) => p[0] === "memory.dram.channels") || [0, 1])[1]) || 1;
  return h("div", {}, h("h3", {}, "DRAM"),
    h("div", { class: "tiles" }, clocks > 0 && tile(percent(dram.bus_clocks / (clocks * channels)), "of the time its buses move data"),
      tile(percent(ratio(dram.row_hits, accesses)), "of the accesses meet an open row"), tile(number(ratio(dram.read_clocks, dram.reads)), "DRAM clocks a read, mean"),
      tile(number(dram.read_bytes), "bytes read"), tile(number(dram.write_bytes), "bytes written"), tile(number(dram.turns), "turns of the bus"), tile(number(dram.refreshes), "refreshes that an access met")),
    legend([["row hits", "var(--s2)"], ["no row open", "var(--s4)"], ["another row open", "var(--s1)"]]),
    stackChart("DRAM accesses", [{ label: "accesses", total: accesses, parts: [{ name: "row hits", value: dram.row_hits, fill: "var(--s2)" }, { name: "no row open", value: dram.row_empty, fill: "var(--s4)" }, { name: "another row open", value: dram.row_misses, fill: "var(--s1)" }] }]));
}

function energySection(run) {
  const energy = run.stats.energy;
  if (!energy || !energy.blocks) return null;
  const bars = (title, object) => {
    const entries = Object.entries(object).filter(([, v]) => v > 0).sort((a, b) => b[1] - a[1]), most = Math.max(...entries.map(([, v]) => v));
    return h("div", {}, h("h3", {}, title), stackChart("Energy, " + title, entries.map(([name, v]) => ({ label: name, parts: [{ name: "µJ a frame", value: v, fill: "var(--s0)" }], total: most * 1.3, value: `${number(v)} µJ`, note: `${percent(ratio(v, energy.frame_uj))} of a frame's energy` })), { text: (x) => number(x) }));
  };
  return section("energy", "Where does the energy go?", h("p", {}, `${number(energy.frame_uj)} µJ a frame, ${number(energy.power_mw)} mW. Static is leakage.`), h("div", { class: "two" }, bars("by block", energy.blocks), bars("by event", energy.events || {})));
}

const parameterText = (value) => (Array.isArray(value) ? value.join(", ") : isNumber(value) ? (Number.isInteger(value) ? String(value) : number(value)) : String(value));
function configSection(run) {
  const rows = run.parameters.map(([path, value, by_default, unit, range, text]) => ({ path, value: parameterText(value), default: parameterText(by_default), unit, range, text, differs: JSON.stringify(value) !== JSON.stringify(by_default) }));
  const count = rows.filter((row) => row.differs).length;
  const table = dataTable("Parameters", [{ key: "path", label: "parameter", long: true }, { key: "value", label: "value" }, { key: "default", label: "default" }, { key: "unit", label: "unit" }, { key: "text", label: "meaning", long: true }], rows, { filter: true, limit: 60, rowClass: (row) => (row.differs ? "chosen" : null) });
  const all = h("input", { type: "checkbox", id: "all-parameters" });
  const restrict = () => {
    table.restrict(all.checked ? null : (row) => row.differs);
    table.element.classList.toggle("hidden", !all.checked && count === 0);
  };
  all.addEventListener("change", restrict);
  restrict();
  return section("config", "Configuration", h("p", {}, count === 0 ? "Every parameter has its default." : `${count} of ${rows.length} parameters ${count === 1 ? "differs" : "differ"} from the defaults.`), h("div", { class: "bar" }, h("label", {}, all, h("span", {}, "all parameters"))), table.element);
}

/** Every number of a frame's or the totals' object by its name in stats.txt. */
function flatNumbers(object, path = "", out = {}) {
  for (const [key, value] of Object.entries(object || {})) {
    const name = path ? path + "." + key : key;
    if (isNumber(value)) out[name] = value;
    else if (value && typeof value === "object" && !Array.isArray(value) && key !== "estimates") flatNumbers(value, key === "blocks" && path === "" ? "" : name, out);
  }
  return out;
}
function derivedNumbers(run) {
  const { derived, energy } = run.stats;
  return { ...flatNumbers({ derived }), ...(energy ? flatNumbers({ energy }) : {}) };
}
const runNumbers = (run) => ({ ...flatNumbers(run.stats.totals), ...derivedNumbers(run) });
function numbersSection(run) {
  const rows = Object.entries(runNumbers(run)).map(([name, value]) => ({ name, value, unit: meaning(run, name)[0], text: meaning(run, name)[1] }));
  return section("numbers", "All numbers", h("p", { class: "soft" }, "Summed over the frames. Filter by words, or by ", command("value>1000"), "."),
    dataTable("All numbers", [{ key: "name", label: "name", long: true }, { key: "value", label: "value", num: true, downFirst: true }, { key: "unit", label: "unit" }, { key: "text", label: "meaning", long: true }], rows, { filter: true, limit: 60, tall: true }).element);
}
function manifestSection(run) {
  const m = run.manifest, rows = [];
  const put = (name, value) => rows.push({ name, value: String(value) });
  put("command line", m.command.join(" ")); put("version", m.version); put("input", m.input.file); put("its SHA-256", m.input.sha256); put("kind", m.input.kind);
  put("frames", `${m.frames.first}:${m.frames.last}`); put("size", `${m.size.width}x${m.size.height}`); put("frames/s of the animation", m.fps); put("fidelity", m.fidelity); put("seed", m.seed);
  put("random stalls", m.random_stall); put("shuffled blocks", m.shuffle); put("fault injected", m.falsified); put("folder", run.folder);
  if (Array.isArray(m.simulated_frames)) put("simulated frames", m.simulated_frames.join(", "));
  return section("manifest", "What was run", dataTable("What was run", [{ key: "name", label: "what" }, { key: "value", label: "value", cell: (row) => h("span", { class: "mono" }, row.value), long: true }], rows).element);
}

function runPage(run) {
  return { title: runTitle(run), below: `artu ${run.manifest.version}`, sections: [summarySection(run), picturesSection(run), cyclesSection(run), timelineSection(run), visitsSection(run), framesSection(run), memorySection(run), energySection(run), configSection(run), numbersSection(run), manifestSection(run)] };
}
