// Where the cycles go: phases of the frame, then blocks, then the five states of a block.
const states = ["busy", "stall_in", "stall_out", "stall_mem", "idle"];
const stateTexts = { busy: "works", stall_in: "starved", stall_out: "blocked by a full channel", stall_mem: "waits for memory", idle: "no part in this phase" };
const phases = ["start", "build", "first", "selective", "flush"];
const phaseTexts = { start: "descriptor and lights are read", build: "the dynamic tree is built", first: "sampling pixels are traced", selective: "candidates are interpolated or traced", flush: "the frame is written back" };
const stateLegend = () => legend(states.map((state) => [`${words(state)}: ${stateTexts[state]}`, `var(--${state})`]));

/** "core3.traversal" -> "core.traversal", "l2_bank1" -> "l2". */
const withoutNumber = (block) => block.replace(/^core\d+\./, "core.").replace(/_bank\d+$/, "");

/** Blocks with their counters, those of one kind added up: Map(name -> {counters, count}). */
function grouped(blocks, together = true) {
  const groups = new Map();
  for (const [block, counters] of Object.entries(blocks)) {
    const name = together ? withoutNumber(block) : block;
    if (!groups.has(name)) groups.set(name, { counters: {}, count: 0 });
    const group = groups.get(name);
    ++group.count;
    for (const [counter, value] of Object.entries(counters)) group.counters[counter] = (group.counters[counter] || 0) + (value || 0);
  }
  return groups;
}
/** Of stackChart: a row a block that has the five states. */
function stateRows(blocks, together) {
  return [...grouped(blocks, together)].filter(([, g]) => states.some((state) => g.counters[state] !== undefined)).map(([name, g]) => {
    const parts = states.map((state) => ({ name: state, value: g.counters[state] || 0, fill: `var(--${state})` }));
    return { label: name + (g.count > 1 ? ` ×${g.count}` : ""), name, parts, total: sum(parts.map((p) => p.value)), note: name === "dram" ? "in DRAM clocks" : "in cycles" };
  });
}

/** Totals, or one frame of a run; [] where there are no cycles. */
function phaseParts(blocks) {
  const control = blocks.control_unit;
  if (!control || control.cycles_first === undefined) return [];
  return phases.map((phase, i) => ({ name: phase, value: control["cycles_" + phase] || 0, fill: series(i) }));
}

function cyclesSection(run) {
  const stats = run.stats, totals = stats.totals, frames = stats.frames;
  if (!stateRows(totals.blocks, true).length) {
    return section("cycles", "Where do the cycles go?", note("", `Cycles of blocks are not known with --fidelity ${stats.fidelity.mode}; `, command("--fidelity event"), " has them."), demandChart(stats));
  }
  const state = { frame: "all", phase: "all", together: true, sort: "chip" };
  const source = () => (state.frame === "all" ? totals : frames[Number(state.frame)]);
  const timelines = run.timeline && run.timeline.frames;
  const phaseChart = stackChart("Phases of the frame", () => {
    const parts = phaseParts(source().blocks);
    return [{ label: state.frame === "all" ? "all frames" : "frame " + source().index, parts, total: sum(parts.map((p) => p.value)), note: "in cycles" }];
  }, { height: 26 });
  const phaseList = h("ul", { class: "legend" });
  function blocksNow() {
    if (state.phase === "all") return source().blocks;
    return phaseBlocks(recorded(), state.phase);
  }
  const rows = () => {
    const list = stateRows(blocksNow(), state.phase === "all" ? state.together : true);
    if (state.sort === "chip") return list;
    const key = (row) => row.parts.find((p) => p.name === state.sort).value / (row.total || 1);
    return list.sort((a, b) => key(b) - key(a));
  };
  const blockChart = stackChart("States of each block", rows);
  const table = h("div"), topDown = h("div");
  const recorded = () => (state.frame === "all" ? timelines : timelines.filter((t) => t.index === source().index));
  /** The three blocks that are most in a state: "dram 95.0 %, l2 24.1 %". */
  const most = (list, name) => list.map((row) => [row.label, ratio(row.parts.find((p) => p.name === name).value, row.total)]).filter(([, share]) => share >= 0.005).sort((a, b) => b[1] - a[1]).slice(0, 3).map(([label, share]) => `${label} ${percent(share)}`).join(", ") || "none";
  function drawTopDown(parts, total) {
    if (!timelines || !timelines.length) return;
    const rowsOf = parts.filter((p) => p.value > 0).map((p) => { const list = stateRows(phaseBlocks(recorded(), p.name), true); return { phase: p.name, cycles: p.value, share: ratio(p.value, total), ...Object.fromEntries(["busy", "stall_mem", "stall_out"].map((name) => [name, most(list, name)])) }; });
    clear(topDown).append(h("h3", {}, "From phases to blocks"), dataTable("From phases to blocks", [{ key: "phase", label: "phase" }, { key: "cycles", label: "cycles", num: true, downFirst: true }, { key: "share", label: "share", num: true, downFirst: true, text: (r) => percent(r.share) }, { key: "busy", label: "busiest", long: true }, { key: "stall_mem", label: "wait most for memory", long: true }, { key: "stall_out", label: "blocked most", long: true }], rowsOf).element);
  }
  function draw() {
    const parts = phaseParts(source().blocks), total = sum(parts.map((p) => p.value));
    clear(phaseList).append(...parts.map((p) => h("li", {}, h("i", { style: { background: p.fill } }), `${p.name} ${percent(ratio(p.value, total))}: ${phaseTexts[p.name]}, ${number(p.value)} cycles`)));
    phaseChart.redraw(); blockChart.redraw();
    drawTopDown(parts, total);
    const columns = [{ key: "block", label: "block" }, ...states.map((name) => ({ key: name, label: words(name), num: true, downFirst: true, text: (row) => percent(row[name]) }))];
    clear(table).append(dataTable("Share of the cycles", columns, rows().map((row) => Object.fromEntries([["block", row.label], ...row.parts.map((p) => [p.name, ratio(p.value, row.total)])]))).element);
  }
  const frame = choice("frames", [["all", "all"], ...frames.map((f, i) => [String(i), String(f.index)])], "all", (v) => { state.frame = v; draw(); });
  const phase = timelines && timelines.length ? choice("phase", [["all", "all"], ...phases.map((p) => [p, p])], "all", (v) => { state.phase = v; draw(); }) : null;
  const order = choice("order", [["chip", "as in the chip"], ...states.map((name) => [name, "most " + words(name)])], "chip", (v) => { state.sort = v; draw(); });
  const each = h("input", { type: "checkbox", id: "each-core" });
  each.addEventListener("change", () => { state.together = !each.checked; draw(); });
  draw();
  return section("cycles", "Where do the cycles go?",
    h("div", { class: "bar" }, frames.length > 1 && frame.element, phase && phase.element, order.element, h("label", {}, each, h("span", {}, "each core and bank"))),
    h("h3", {}, "Phases of the frame"), phaseChart, phaseList, topDown,
    h("h3", {}, "Blocks and their states"), stateLegend(), blockChart,
    !phase && h("p", { class: "soft" }, "By phase: with ", command("artu run --timeline"), "."),
    h("details", {}, h("summary", {}, "As a table"), table), demandChart(stats));
}

/** What each resource would need at least if nothing else took time, as a share of the cycles. */
function demandChart(stats) {
  if (!stats.demand || !stats.demand.shares) return null;
  const entries = Object.entries(stats.demand.shares).sort((a, b) => b[1] - a[1]);
  const most = Math.max(1, ...entries.map(([, share]) => share));
  return h("div", {}, h("h3", {}, "Demand of each resource"),
    h("p", { class: "soft" }, `What it would take if nothing else did, as a share of the cycles. The bottleneck is: ${stats.demand.bottleneck}.`),
    stackChart("Demand of each resource", entries.map(([name, share]) => ({ label: name, parts: [{ name: "share", value: share, fill: "var(--s0)" }], total: most, value: percent(share) })), { text: percent }));
}
