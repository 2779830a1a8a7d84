// Two runs side by side, or more in one table. The first is what the others are compared with.

/** Names that tell runs apart: the folder's, or the whole path where two have one name. */
function runLabels(runs) {
  const twice = runs.some((run, i) => runs.some((other, j) => i !== j && other.name === run.name));
  return runs.map((run) => (twice ? run.folder : run.name));
}

/** How far two numbers are apart, for sorting: 0 for equal ones, Infinity where one of them alone is 0, null where one is missing. */
function change(a, b) {
  if (!isNumber(a) || !isNumber(b)) return a === b ? 0 : null;
  if (a === b) return 0;
  return a === 0 || b === 0 || a < 0 !== b < 0 ? Infinity : Math.abs(Math.log(b / a));
}
function ratioText(a, b) {
  if (!isNumber(a) || !isNumber(b)) return "only one";
  if (a === b) return "1";
  return a === 0 ? "from 0" : (b / a >= 100 ? number(b / a) : (b / a).toPrecision(4)) + "×";
}

// Figures of which less, or more, is better.
const lessIsBetter = ["derived.cycles_per_frame", "energy.frame_uj", "energy.ray_nj", "energy.power_mw", "derived.dram_bytes_per_ray"];
const moreIsBetter = ["derived.fps", "derived.mrays_per_second"];
function judgement(name, a, b) {
  if (a === b || !isNumber(a) || !isNumber(b)) return null;
  if (lessIsBetter.includes(name)) return b < a ? "better" : "worse";
  return moreIsBetter.includes(name) ? (b > a ? "better" : "worse") : null;
}

function sameInputs(runs) {
  const of = (run) => ({ input: run.manifest.input.file, "SHA-256 of the input": run.manifest.input.sha256, frames: `${run.manifest.frames.first}:${run.manifest.frames.last}`, size: `${run.manifest.size.width}x${run.manifest.size.height}`, fidelity: run.manifest.fidelity, version: run.manifest.version });
  const all = runs.map(of);
  return Object.keys(all[0]).map((what) => ({ what, values: all.map((a) => a[what]), differs: all.some((a) => a[what] !== all[0][what]) }));
}

function runsSection(runs, labels) {
  const facts = sameInputs(runs), differ = facts.filter((f) => f.differs && f.what !== "input").map((f) => f.what);
  const columns = [{ key: "what", label: "" }, ...labels.map((label, i) => ({ key: "v" + i, label: label || "(no name)", long: true }))];
  columns[0].label = "what";
  const rows = facts.map((f) => Object.fromEntries([["what", f.what], ...f.values.map((v, i) => ["v" + i, v])]));
  return section("runs", "Runs", differ.length ? note("warn", `They differ in more than the configuration: ${differ.join(", ")}.`) : note("good", "The same input, frames, size, fidelity and version."),
    runs.some((run) => run.manifest.falsified) && note("bad", "A fault was injected into one of them: its figures are not the unit's."),
    dataTable("Runs", columns, rows).element);
}

function figuresSection(runs, labels) {
  // Cores and banks together: runs need not have the same number of them.
  const all = runs.map((run) => ({ ...flatNumbers({ ...run.stats.totals, blocks: Object.fromEntries([...grouped(run.stats.totals.blocks)].map(([name, g]) => [name, g.counters])) }), ...derivedNumbers(run) }));
  const names = [...new Set(all.flatMap((numbers) => Object.keys(numbers)))];
  const single = (name) => [name, name.replace(/^core\./, "core0."), name.replace(/^l2\./, "l2_bank0.")];
  const meaningOf = (name) => runs.flatMap((run) => single(name).map((one) => meaning(run, one))).find((m) => m[1]) || ["", ""];
  const rows = names.map((name) => {
    const values = all.map((numbers) => numbers[name]);
    const changes = values.map((v) => change(values[0], v));
    return { name, change: changes.includes(null) ? null : Math.max(...changes), unit: meaningOf(name)[0], text: meaningOf(name)[1], ...Object.fromEntries(values.map((v, i) => ["v" + i, v])) };
  });
  const two = runs.length === 2;
  const last = two ? [{ key: "change", label: "second / first", num: true, downFirst: true, cell: (row) => h("span", { class: judgement(row.name, row.v0, row.v1) }, ratioText(row.v0, row.v1)) }]
    : [{ key: "change", label: "largest change", num: true, downFirst: true, text: (row) => (row.change === null ? "not in all" : row.change === 0 ? "none" : row.change === Infinity ? "to or from 0" : Math.exp(row.change).toPrecision(4) + "×") }];
  const columns = [{ key: "name", label: "figure", long: true }, ...labels.map((label, i) => ({ key: "v" + i, label: cut(label, 160), title: label, num: true, downFirst: true })), ...last, { key: "unit", label: "unit" }, { key: "text", label: "meaning", long: true }];
  const table = dataTable("Figures", columns, rows, { filter: true, limit: 80, sort: "change", down: true, tall: true });
  const head = new Set([...lessIsBetter, ...moreIsBetter, "traced_share", "derived.rays_per_pixel", "derived.node_visits_per_ray", "derived.dram_gb_per_second"]);
  const equal = h("input", { type: "checkbox", id: "equal" });
  const restrict = () => table.restrict(equal.checked ? null : (row) => row.change !== 0);
  equal.addEventListener("change", restrict);
  restrict();
  const main = dataTable("Main figures", columns, rows.filter((row) => head.has(row.name)));
  return [section("main-figures", "Main figures", main.element),
    section("figures", "All figures, by how much they change", h("div", { class: "bar" }, h("label", {}, equal, h("span", {}, "equal ones, too"))), table.element)];
}

function comparedPictures(runs, labels) {
  if (!runs.some((run) => run.pictures.length)) return null;
  const viewer = pictureViewer(runs.map((run, i) => ({ label: labels[i], width: run.manifest.size.width, pictures: run.pictures })));
  const kind = (i) => Object.keys(kindTexts).find((k) => runs[i].pictures.some((p) => p.kind === k));
  if (runs.length === 2 && runs.every((run) => run.pictures.length)) viewer.compare({ source: 0, kind: kind(0) }, { source: 1, kind: kind(1) });
  return section("pictures", "Pictures", h("p", { class: "soft" }, "Left of the wipe the first picture, right of it the other; or both in turns."), viewer);
}

function comparedCycles(runs, labels) {
  const parts = runs.map((run, i) => {
    const phasesNow = phaseParts(run.stats.totals.blocks), rows = stateRows(run.stats.totals.blocks, true);
    return rows.length ? h("div", {}, h("h3", {}, labels[i]), stackChart("Phases of " + labels[i], [{ label: "phases", parts: phasesNow, total: sum(phasesNow.map((p) => p.value)) }], { height: 22 }), stackChart("States of each block of " + labels[i], rows)) : null;
  }).filter(Boolean);
  if (!parts.length) return null;
  return section("cycles", "Where do the cycles go?", legend(phases.map((phase, i) => [phase, series(i)])), stateLegend(), h("div", { class: "two" }, parts));
}

function comparedConfig(runs, labels) {
  const all = runs.map((run) => new Map(run.parameters.map((p) => [p[0], p])));
  const rows = [...all[0].keys()].map((path) => {
    const values = all.map((parameters) => (parameters.get(path) || [])[1]), p = all[0].get(path);
    return { path, differs: values.some((v) => JSON.stringify(v) !== JSON.stringify(values[0])), unit: p[3], text: p[5], ...Object.fromEntries(values.map((v, i) => ["v" + i, v === undefined ? "" : parameterText(v)])) };
  }).filter((row) => row.differs);
  return section("config", "Configuration", h("p", {}, rows.length ? (rows.length === 1 ? "One parameter differs." : `${rows.length} parameters differ.`) : "All parameters are the same."),
    rows.length > 0 && dataTable("Parameters that differ", [{ key: "path", label: "parameter", long: true }, ...labels.map((label, i) => ({ key: "v" + i, label: cut(label, 160), title: label })), { key: "unit", label: "unit" }, { key: "text", label: "meaning", long: true }], rows, { filter: rows.length > 8, limit: 200 }).element);
}

function comparisonPage(data) {
  const runs = data.runs, labels = runLabels(runs);
  const title = runs.length === 2 ? `${labels[0]} and ${labels[1]}` : `${runs.length} runs`;
  return { title, below: runs.length === 2 ? "Two runs side by side" : "The first is what the others are compared with: " + labels[0], sections: [runsSection(runs, labels), ...figuresSection(runs, labels), comparedPictures(runs, labels), comparedCycles(runs, labels), comparedConfig(runs, labels)] };
}
