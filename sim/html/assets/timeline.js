// Over time, where the run has recorded it (artu run --timeline, docs/report.md).
const timelineHint = () => note("", "This run has not recorded it; ", command("artu run --timeline"), " does.");

/** Of these frames, the blocks' states in one phase: as in stats.json. */
function phaseBlocks(frames, phase) {
  const blocks = {};
  for (const part of frames.flatMap((frame) => frame.phases)) {
    if (part.phase !== phase) continue;
    for (const [block, counters] of Object.entries(part.blocks)) {
      blocks[block] = blocks[block] || {};
      for (const state of states) blocks[block][state] = (blocks[block][state] || 0) + (counters[state] || 0);
    }
  }
  return blocks;
}

/** Where each look began: [from, to] in cycles. */
const spans = (frame) => frame.at.map((to, i) => [i ? frame.at[i - 1] : 0, to]);
const phaseMarks = (frame) => frame.phases.filter((p) => (p.to - p.from) / frame.cycles > 0.03).map((p) => ({ x: p.from, label: p.phase }));
/** A value a look, as steps. */
const stepsOf = (frame, of) => spans(frame).map(([from], i) => [from, of(i)]).concat([[frame.cycles, of(frame.at.length - 1)]]);

/** A row a block, time to the right: how much of each look it was in the state. */
function heatChart(label, frame, state) {
  return chart(label, (place, width) => {
    const rows = Object.entries(frame.blocks), narrow = width < 560, left = narrow ? 118 : Math.min(230, width * 0.28), row = 16, wide = Math.max(40, width - left);
    const canvas = h("canvas", { width: Math.floor(wide), height: rows.length * row, role: "img", "aria-label": `${label}: ${words(state.value)}` });
    const context = canvas.getContext("2d"), ink = color(state.value === "idle" ? "soft" : state.value), paper = color("grid"), limits = spans(frame);
    rows.forEach(([, block], r) => {
      const total = (i) => sum(states.map((name) => block[name][i] || 0));
      limits.forEach(([from, to], i) => {
        const x = Math.floor((from / frame.cycles) * canvas.width), next = Math.ceil((to / frame.cycles) * canvas.width);
        context.globalAlpha = 1; context.fillStyle = paper; context.fillRect(x, r * row, next - x, row - 1);
        context.globalAlpha = ratio(block[state.value][i], total(i)); context.fillStyle = ink; context.fillRect(x, r * row, next - x, row - 1);
      });
    });
    context.globalAlpha = 1; context.fillStyle = color("ink");
    for (const phase of frame.phases.slice(1)) context.fillRect(Math.floor((phase.from / frame.cycles) * canvas.width), 0, 1, canvas.height);
    canvas.addEventListener("pointermove", (e) => {
      const box = canvas.getBoundingClientRect(), r = Math.min(rows.length - 1, Math.max(0, Math.floor((e.clientY - box.top) / row))), cycle = ((e.clientX - box.left) / box.width) * frame.cycles;
      const i = Math.max(0, limits.findIndex(([, to]) => cycle <= to)), [name, block] = rows[r], total = sum(states.map((s2) => block[s2][i] || 0));
      showTip([name + (block.count > 1 ? ` ×${block.count}` : ""), `cycles ${number(limits[i][0])} to ${number(limits[i][1])}`, ...states.map((s2) => `${words(s2)}: ${percent(ratio(block[s2][i], total))}`)].join("\n"), e.clientX, e.clientY);
    });
    canvas.addEventListener("pointerleave", hideTip);
    const labels = s("svg", { viewBox: `0 0 ${left} ${rows.length * row}`, width: left, height: rows.length * row, style: { width: left + "px", flex: "none" } },
      rows.map(([name], r) => s("text", { x: left - 6, y: r * row + 12, "text-anchor": "end" }, cut(name, left - 8))));
    place.append(h("div", { style: { display: "flex" } }, labels, canvas));
  });
}

function timelineSection(run) {
  if (!run.timeline) return section("timeline", "Over time", timelineHint());
  const frames = run.timeline.frames, clock = Number((run.parameters.find((p) => p[0] === "unit.clock_mhz") || run.parameters.find((p) => p[0].endsWith("clock_mhz")) || [0, 1])[1]);
  const state = { value: "busy", frame: 0, channel: null }, place = h("div");
  const seconds = (cycles) => cycles / (clock * 1e6);
  function draw() {
    const frame = frames[state.frame], width = (i) => spans(frame)[i][1] - spans(frame)[i][0];
    const x = { label: "cycle", low: 0, high: frame.cycles }, marks = () => phaseMarks(frame);
    const rate = (name) => stepsOf(frame, (i) => ratio(frame.counts[name][i], seconds(width(i))) / 1e9);
    let begun = 0;
    const flight = frame.at.map((at, i) => [at, (begun += frame.counts.rays_begun[i] - frame.counts.rays_finished[i])]);
    const levels = Object.entries(frame.channels).map(([name, c]) => ({ name, capacity: c.capacity, count: c.count, mean: ratio(sum(c.level), c.level.length) / (c.capacity || 1), most: Math.max(...c.level), full: ratio(c.level.filter((v) => v === c.capacity).length, c.level.length) }));
    if (!frame.channels[state.channel]) state.channel = levels.slice().sort((a, b) => b.mean - a.mean)[0].name;
    const shown = () => [{ name: state.channel, fill: "var(--s0)", points: frame.at.map((at, i) => [at, frame.channels[state.channel].level[i]]) }];
    const levelChart = lineChart("Level of a channel", shown, { x, y: {}, marks });
    const pick = choice("channel", levels.map((l) => [l.name, `${l.name} (${l.capacity})`]), state.channel, (name) => { state.channel = name; levelChart.redraw(); });
    clear(place).append(
      h("h3", {}, "Blocks"), h("p", { class: "soft" }, `The stronger the colour, the more of the time the block ${state.value === "busy" ? "works" : "is in this state: " + stateTexts[state.value]}. Lines are where phases begin; a look is ${number(frame.interval)} cycles.`), heatChart("Blocks over time", frame, state),
      h("h3", {}, "DRAM traffic, GB/s"), lineChart("DRAM traffic", [{ name: "read", fill: "var(--s0)", points: rate("read_bytes") }, { name: "written", fill: "var(--s1)", points: rate("write_bytes") }], { x, marks, steps: true }),
      h("h3", {}, "Rays in traversal and intersection"), lineChart("Rays in flight", [{ name: "rays", fill: "var(--s2)", points: flight }], { x, marks }),
      h("h3", {}, "Channels"), h("div", { class: "bar" }, pick.element), levelChart,
      h("details", {}, h("summary", {}, "All channels as a table"), dataTable("Channels", [{ key: "name", label: "channel", long: true }, { key: "count", label: "number", num: true }, { key: "capacity", label: "capacity", num: true }, { key: "mean", label: "filled, mean", num: true, downFirst: true, text: (r) => percent(r.mean) }, { key: "most", label: "most", num: true, downFirst: true }, { key: "full", label: "full at", num: true, downFirst: true, text: (r) => percent(r.full) }], levels, { sort: "mean", down: true }).element));
  }
  const pickFrame = choice("frame", frames.map((f, i) => [String(i), String(f.index)]), "0", (i) => { state.frame = Number(i); draw(); });
  const pickState = choice("state", states.map((name) => [name, words(name)]), "busy", (name) => { state.value = name; draw(); });
  draw();
  return section("timeline", "Over time", h("div", { class: "bar" }, frames.length > 1 && pickFrame.element, pickState.element), place);
}

/** Counts in at most `most` bars: [{from, to, value}]. */
function bins(values, most) {
  const size = Math.max(1, Math.ceil(values.length / most)), list = [];
  for (let from = 0; from < values.length; from += size) list.push({ from, to: Math.min(values.length, from + size) - 1, value: sum(values.slice(from, from + size)) });
  return list;
}
function histogramChart(label, values, fillColor, kind) {
  return chart(label, (place, width) => {
    const list = bins(values, Math.max(10, Math.floor(width / 14))), most = Math.max(...list.map((b) => b.value), 1), all = sum(values);
    const frame = axes(place, width, 190, { x: { low: 0, high: Math.max(values.length, 1), label: "inner nodes visited" }, y: { low: 0, high: most * 1.05 } });
    for (const b of list) {
      if (b.value === 0) continue;
      const x = frame.X(b.from), bar = s("rect", { x, width: Math.max(1, frame.X(b.to + 1) - x - 1), y: frame.Y(b.value), height: Math.max(0.5, frame.bottom - frame.Y(b.value)), fill: fillColor });
      frame.svg.append(tipped(bar, () => `${b.from === b.to ? b.from : b.from + " to " + b.to} nodes: ${number(b.value)} ${kind} rays (${percent(b.value / all)})`));
    }
  });
}
function visitsSection(run) {
  const title = "Node visits a ray";
  if (!run.timeline) return section("visits", title, timelineHint());
  const kinds = Object.keys(run.timeline.frames[0].visits), total = {};
  for (const frame of run.timeline.frames) for (const kind of kinds) frame.visits[kind].forEach((count, n) => { total[kind] = total[kind] || []; total[kind][n] = (total[kind][n] || 0) + count; });
  for (const kind of kinds) total[kind] = Array.from(total[kind] || [], (v) => v || 0);
  const quantile = (values, share) => { let left = share * sum(values); for (let n = 0; n < values.length; ++n) if ((left -= values[n]) <= 0) return n; return values.length - 1; };
  const rows = kinds.filter((kind) => sum(total[kind]) > 0).map((kind) => ({ kind, rays: sum(total[kind]), mean: ratio(sum(total[kind].map((c, n) => c * n)), sum(total[kind])), median: quantile(total[kind], 0.5), most99: quantile(total[kind], 0.99), most: total[kind].length - 1 }));
  return section("visits", title, h("p", { class: "soft" }, "Inner nodes of the trees, rays of all frames."),
    h("div", { class: "two" }, rows.map((row, i) => h("div", {}, h("h3", {}, `${row.kind}: ${number(row.rays)} rays`), histogramChart(`Node visits of ${row.kind} rays`, total[row.kind], series(i), row.kind)))),
    dataTable("Node visits", [{ key: "kind", label: "rays" }, { key: "rays", label: "number", num: true }, { key: "mean", label: "visits, mean", num: true }, { key: "median", label: "median", num: true }, { key: "most99", label: "99 % have no more than", num: true }, { key: "most", label: "most", num: true }], rows).element);
}
