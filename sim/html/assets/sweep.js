// A sweep: which points are best, what each parameter does, and all of it as a table that filters the charts.

const identity = ["point", "folder", "scene", "frames", "size", "fidelity", "status", "confirms"];

/** The sweep's rows as objects, and what is known of its columns. */
function sweepModel(sweep) {
  const rows = sweep.rows.map((cells) => Object.fromEntries(sweep.columns.map((name, i) => [name, cells[i]])));
  const parameters = sweep.description.parameters.map((p) => p.path).filter((path) => sweep.columns.includes(path));
  const numeric = sweep.columns.filter((name) => rows.some((row) => isNumber(row[name])) && rows.every((row) => row[name] === null || isNumber(row[name])));
  const figures = numeric.filter((name) => !identity.includes(name) && !parameters.includes(name) && !/\.(low|high)$/.test(name));
  const varying = figures.filter((name) => { const seen = rows.map((row) => row[name]).filter(isNumber); return seen.some((v) => v !== seen[0]); });
  const goals = {};
  for (const o of sweep.description.objectives || []) if (o && typeof o.figure === "string") goals[o.figure] = o.goal === "maximise" ? 1 : -1;
  const goal = (name) => goals[name] || (/^(fps|mrays_per_second|hit_rate\..*)$/.test(name) ? 1 : -1);
  const usable = [...new Set([...Object.keys(goals).filter((name) => numeric.includes(name)), ...varying, ...parameters.filter((name) => numeric.includes(name))])];
  if (usable.length < 2) usable.push(...figures.filter((name) => !usable.includes(name)).slice(0, 2));
  return { rows, parameters, numeric, figures: usable, goal, units: Object.fromEntries(sweep.description.parameters.map((p) => [p.path, p.unit || ""])) };
}

/** Rows than which no other is as good in both and better in one. goal: 1 more, -1 less is better. */
function paretoFront(rows, x, y, goalX, goalY) {
  const sorted = rows.filter((row) => isNumber(row[x]) && isNumber(row[y])).sort((a, b) => goalX * (b[x] - a[x]) || goalY * (b[y] - a[y]));
  const front = [];
  let best = -Infinity;
  for (let i = 0; i < sorted.length;) {
    let end = i;
    while (end < sorted.length && sorted[end][x] === sorted[i][x]) ++end;  // one x: the best y first
    const top = goalY * sorted[i][y];
    if (top > best) { for (let j = i; j < end && sorted[j][y] === sorted[i][y]; ++j) front.push(sorted[j]); best = top; }
    i = end;
  }
  return front;
}

const valueText = (value) => (isNumber(value) ? number(value) : value === null || value === undefined ? "–" : String(value));
const describePoint = (model, row, more) => [`point ${valueText(row.point)}`, row.scene, ...model.parameters.map((p) => `${p} = ${valueText(row[p])}`), ...more.map((m) => `${m}: ${valueText(row[m])}`)].join("\n");

/** Low to high along the colours of a line from blue to orange. */
function tint(share) {
  const a = [0, 114, 178], b = [213, 94, 0], at = Math.max(0, Math.min(1, share));
  return `rgb(${a.map((v, i) => Math.round(v + (b[i] - v) * at)).join(",")})`;
}
function range(rows, name) {
  const values = rows.map((row) => row[name]).filter(isNumber);
  return values.length ? [Math.min(...values), Math.max(...values)] : [0, 1];
}
/** Where a value lies on an axis, 0 to 1: numbers by size (by logarithm where they span a lot), names by order. */
function placer(rows, name) {
  const values = [...new Set(rows.map((row) => row[name]).filter((v) => v !== null && v !== undefined))].sort(compareValues);
  if (values.length && values.every(isNumber)) {
    const low = values[0], high = values[values.length - 1], log = low > 0 && high / low >= 20, f = log ? Math.log : (v) => v;
    return { place: (v) => (isNumber(v) ? (high === low ? 0.5 : (f(v) - f(low)) / (f(high) - f(low))) : null), marks: values.length <= 6 ? values : [low, log ? Math.sqrt(low * high) : (low + high) / 2, high] };
  }
  return { place: (v) => (values.includes(v) ? (values.length === 1 ? 0.5 : values.indexOf(v) / (values.length - 1)) : null), marks: values.slice(0, 12) };
}

function frontSection(model, state, update) {
  const place = h("div"), list = h("div");
  const names = model.figures.map((name) => [name, name]);
  const goalText = (name) => (state.goals[name] ?? model.goal(name)) > 0;
  const pickX = choice("across", names, state.x, (v) => { state.x = v; update(); });
  const pickY = choice("up", names, state.y, (v) => { state.y = v; update(); });
  const flip = (axis) => h("button", { type: "button", onclick: () => { const name = state[axis]; state.goals[name] = goalText(name) ? -1 : 1; update(); } });
  const flipX = flip("x"), flipY = flip("y");
  const pickColor = choice("colour", [["", "none"], ...model.parameters.map((p) => [p, p])], state.color, (v) => { state.color = v; update(); });
  const drawn = chart("Pareto front", (inside, width) => {
    const rows = state.rows.filter((row) => isNumber(row[state.x]) && isNumber(row[state.y]));
    if (!rows.length) { inside.append(h("p", {}, "No point has both figures.")); return; }
    const axis = (name) => { const [low, high] = range(rows, name), log = low > 0 && high / low >= 20, pad = high > low ? (high - low) * 0.04 : Math.abs(high) * 0.05 || 1; return log ? { low: low / 1.1, high: high * 1.1, log, label: name } : { low: low - pad, high: high + pad, label: name }; };
    const y = axis(state.y), frame = axes(inside, width, Math.min(460, Math.max(300, width * 0.5)), { x: axis(state.x), y });
    const line = state.front.map((row) => [frame.X(row[state.x]), frame.Y(row[state.y])]).sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    if (line.length > 1) frame.svg.append(s("path", { d: "M" + line.map((p) => p.map((v) => v.toFixed(1)).join(",")).join("L"), fill: "none", stroke: "var(--accent)", "stroke-width": 1.5 }));
    const color = state.color ? placer(rows, state.color) : null, onFront = new Set(state.front);
    for (const row of [...rows.filter((r) => !onFront.has(r)), ...state.front]) {
      const front = onFront.has(row), circle = s("circle", { class: front ? "front" : "other", cx: frame.X(row[state.x]), cy: frame.Y(row[state.y]), r: front ? 6 : 4, fill: color ? tint(color.place(row[state.color]) ?? 0) : front ? "var(--accent)" : "var(--s6)", "fill-opacity": front ? 1 : 0.6,
        stroke: row === state.chosen ? "var(--ink)" : front ? "var(--card)" : "none", "stroke-width": row === state.chosen ? 3 : 1, tabindex: front ? 0 : null, role: front ? "button" : null, "aria-label": front ? describePoint(model, row, [state.x, state.y]).replace(/\n/g, ", ") : null });
      const choose = () => { state.chosen = row; update(); };
      circle.addEventListener("click", choose);
      circle.addEventListener("keydown", (e) => { if (e.key === "Enter") choose(); });
      frame.svg.append(tipped(circle, () => describePoint(model, row, [state.x, state.y])));
    }
  });
  const detail = h("div");
  function draw() {
    pickX.select.value = state.x; pickY.select.value = state.y;
    flipX.textContent = goalText(state.x) ? "more is better" : "less is better"; flipY.textContent = goalText(state.y) ? "more is better" : "less is better";
    flipX.setAttribute("aria-label", `${state.x}: ${flipX.textContent}; change`); flipY.setAttribute("aria-label", `${state.y}: ${flipY.textContent}; change`);
    state.front = paretoFront(state.rows, state.x, state.y, goalText(state.x) ? 1 : -1, goalText(state.y) ? 1 : -1);
    drawn.redraw();
    const columns = [{ key: "point", label: "point", num: true }, ...model.parameters.map((p) => ({ key: p, label: p, num: model.numeric.includes(p) })), ...[...new Set([state.x, state.y])].filter((n) => !model.parameters.includes(n)).map((n) => ({ key: n, label: n, num: true }))];
    clear(list).append(dataTable("Points on the front", columns, state.front, { sort: state.x, rowClass: (row) => (row === state.chosen ? "chosen" : null), choose: (row) => { state.chosen = row; update(); } }).element);
    clear(detail).append(...(state.chosen ? [note("", `Chosen: point ${valueText(state.chosen.point)}, ${state.chosen.folder || ""}. `, command(`artu report ${state.folder}/${state.chosen.folder || ""}`), " makes its page.")] : []));
  }
  place.append(h("div", { class: "bar" }, pickX.element, flipX, pickY.element, flipY, pickColor.element), drawn, detail, h("h3", {}, "On the front"), list);
  return { element: section("front", "Pareto front", h("p", { class: "soft" }, "Points than which no other is as good in both figures and better in one. Choose one with a click."), place), draw };
}

const mostLines = 1500;
function parallelSection(model, state, update) {
  const names = () => [...model.parameters, ...[state.x, state.y].filter((n, i, all) => !model.parameters.includes(n) && all.indexOf(n) === i)];
  const height = 300, hint = h("p", { class: "soft" });
  const drawn = chart("Parallel coordinates", (inside, width) => {
    const axesNow = names(), wide = Math.max(width, axesNow.length * 96), top = 40, bottom = height - 24, X = (i) => 50 + (i * (wide - 100)) / Math.max(1, axesNow.length - 1);
    const svg = s("svg", { viewBox: `0 0 ${wide} ${height}`, height, style: { width: wide + "px" } });
    const places = axesNow.map((name) => placer(state.all, name)), Y = (i, v) => { const p = places[i].place(v); return p === null ? null : bottom - p * (bottom - top); };
    const step = Math.max(1, Math.ceil(state.rows.length / mostLines)), color = placer(state.rows, state.y), onFront = new Set(state.front);
    const few = state.rows.filter((row, i) => i % step === 0 || onFront.has(row) || row === state.chosen);
    hint.textContent = `A line is a point, its colour is ${state.y} from low (blue) to high (orange); the front is thick. Drag along an axis to keep a range of it, click its name to forget that.` + (step > 1 ? ` Every ${step}th of ${number(state.rows.length)} lines is drawn.` : "");
    for (const row of few) {
      const points = axesNow.map((name, i) => [X(i), Y(i, row[name])]).filter((p) => p[1] !== null), front = onFront.has(row);
      const path = s("path", { d: "M" + points.map((p) => p.map((v) => v.toFixed(1)).join(",")).join("L"), fill: "none", stroke: row === state.chosen ? "var(--ink)" : tint(color.place(row[state.y]) ?? 0), "stroke-width": row === state.chosen ? 4 : front ? 2.6 : 1, "stroke-opacity": front || row === state.chosen ? 1 : 0.45 });
      path.addEventListener("click", () => { state.chosen = row; update(); });
      svg.append(tipped(path, () => describePoint(model, row, [state.x, state.y])));
    }
    axesNow.forEach((name, i) => {
      const x = X(i), axis = s("g", {}, s("line", { class: "axis", x1: x, x2: x, y1: top, y2: bottom }));
      for (const mark of places[i].marks) { const y = Y(i, mark); const last = i + 1 === axesNow.length && i > 0; if (y !== null) axis.append(s("text", { class: "soft halo", x: last ? x - 4 : x + 4, y: y + 4, "text-anchor": last ? "end" : "start" }, isNumber(mark) ? short(mark) : cut(String(mark), 60))); }
      const brush = state.brushes[name], edge = i === 0 ? "start" : i + 1 === axesNow.length ? "end" : "middle", label = s("text", { class: "halo", x: edge === "start" ? 4 : edge === "end" ? wide - 4 : x, y: i % 2 ? 12 : 26, "text-anchor": edge, tabindex: 0, role: "button", "aria-label": `${name}${brush ? ": forget its range" : ""}` }, (brush ? "✕ " : "") + cut(name, 170));
      const forget = () => { delete state.brushes[name]; update(); };
      label.addEventListener("click", forget);
      label.addEventListener("keydown", (e) => { if (e.key === "Enter") forget(); });
      if (brush) axis.append(s("rect", { class: "brush", x: x - 8, width: 16, y: bottom - brush[1] * (bottom - top), height: Math.max(2, (brush[1] - brush[0]) * (bottom - top)), fill: "var(--accent)", "fill-opacity": 0.35 }));
      const area = s("rect", { "data-axis": name, x: x - 12, y: top - 4, width: 24, height: bottom - top + 8, fill: "transparent", style: { cursor: "ns-resize", touchAction: "pan-x" } });
      area.addEventListener("pointerdown", (e) => {
        const box = svg.getBoundingClientRect(), share = (event) => Math.max(0, Math.min(1, (bottom - (event.clientY - box.top) * (height / box.height)) / (bottom - top))), from = share(e);
        area.setPointerCapture(e.pointerId);
        area.addEventListener("pointerup", (end) => { const to = share(end); if (Math.abs(to - from) > 0.02) { state.brushes[name] = [Math.min(from, to), Math.max(from, to)]; update(); } }, { once: true });
      });
      axis.append(area, label);
      svg.append(axis);
    });
    inside.append(h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Parallel coordinates" }, svg));
  });
  return { element: section("parallel", "Parallel coordinates", hint, drawn), draw: () => drawn.redraw() };
}

/** What a parameter does to a figure: mean, least and most of the points with each value; many values in eight parts of them at most. */
function effectOf(rows, parameter, figure) {
  const used = rows.filter((row) => isNumber(row[figure]) && row[parameter] !== null);
  const distinct = [...new Set(used.map((row) => row[parameter]))].sort(compareValues);
  let groups;
  if (distinct.length > 8 && distinct.every(isNumber)) {
    const size = Math.ceil(distinct.length / 8);
    groups = [];
    for (let i = 0; i < distinct.length; i += size) {
      const part = distinct.slice(i, i + size), first = part[0], last = part[part.length - 1];
      groups.push([first === last ? short(first) : `${short(first)}–${short(last)}`, used.filter((row) => row[parameter] >= first && row[parameter] <= last)]);
    }
  } else groups = distinct.map((value) => [isNumber(value) ? short(value) : String(value), used.filter((row) => row[parameter] === value)]);
  const levels = groups.map(([label, part]) => { const values = part.map((row) => row[figure]); return { label, count: values.length, mean: ratio(sum(values), values.length), low: Math.min(...values), high: Math.max(...values) }; });
  const means = levels.map((level) => level.mean);
  return { parameter, levels, size: levels.length ? Math.max(...means) - Math.min(...means) : 0 };
}
function effectsSection(model, state, update) {
  const place = h("div", { class: "two" });
  const pick = choice("figure", model.figures.filter((f) => !model.parameters.includes(f)).map((name) => [name, name]), state.figure, (v) => { state.figure = v; draw(); });
  function effectChart(effect, low, high) {
    return chart(`Effect of ${effect.parameter} on ${state.figure}`, (inside, width) => {
      const count = effect.levels.length, frame = axes(inside, width, 190, { x: { low: -0.5, high: count - 0.5, values: effect.levels.map((_, i) => i), text: (i) => cut(effect.levels[i].label, Math.max(30, (width - 62) / count)), label: model.units[effect.parameter] ? `${effect.parameter}, ${model.units[effect.parameter]}` : effect.parameter }, y: { low, high } });
      frame.svg.append(s("path", { d: "M" + effect.levels.map((l, i) => `${frame.X(i)},${frame.Y(l.mean)}`).join("L"), fill: "none", stroke: "var(--s0)", "stroke-width": 2 }));
      effect.levels.forEach((l, i) => frame.svg.append(tipped(s("g", { tabindex: 0, role: "img", "aria-label": `${l.label}: mean ${number(l.mean)}` },
        s("line", { x1: frame.X(i), x2: frame.X(i), y1: frame.Y(l.low), y2: frame.Y(l.high), stroke: "var(--s6)", "stroke-width": 1.5 }), s("rect", { x: frame.X(i) - 12, width: 24, y: frame.top, height: frame.bottom - frame.top, fill: "transparent" }), s("circle", { cx: frame.X(i), cy: frame.Y(l.mean), r: 4.5, fill: "var(--s0)" })),
        () => `${effect.parameter} = ${l.label}\nmean ${number(l.mean)} of ${l.count} points\n${number(l.low)} to ${number(l.high)}`)));
    });
  }
  function draw() {
    pick.select.value = state.figure;
    clear(place);
    const [low, high] = range(state.rows, state.figure), pad = (high - low) * 0.05 || Math.abs(high) * 0.05 || 1;
    const effects = model.parameters.map((p) => effectOf(state.rows, p, state.figure)).filter((e) => e.levels.length).sort((a, b) => b.size - a.size);
    for (const effect of effects) place.append(h("div", {}, h("h3", {}, `${effect.parameter}: ${number(effect.size)} between means`), effectChart(effect, low >= 0 ? Math.max(0, low - pad) : low - pad, high + pad)));
    if (!effects.length) place.append(h("p", {}, "No point has this figure."));
  }
  return { element: section("effects", "Main effects", h("p", { class: "soft" }, "The mean of all points with a value, whatever else they have; the line through it is from the least to the most. The parameter that does most comes first."), h("div", { class: "bar" }, pick.element), place), draw };
}

function sweepPage(data) {
  const sweep = data.sweep, d = sweep.description, model = sweepModel(sweep);
  const scenes = [...new Set(model.rows.map((row) => row.scene))], fidelities = [...new Set(model.rows.map((row) => row.fidelity))];
  const objectives = (d.objectives || []).map((o) => o.figure).filter((name) => model.figures.includes(name));
  const fallback = ["cycles_per_frame", "energy.frame_uj", "dram_gb_per_second", ...model.figures].filter((name) => model.figures.includes(name) && !objectives.includes(name));
  const [x, y] = [...objectives, ...fallback];
  const state = { rows: [], all: [], front: [], chosen: null, goals: {}, brushes: {}, color: "", x: y ?? x, y: x, figure: [x, y, ...model.figures].find((n) => n && !model.parameters.includes(n)) || x, scene: scenes[0], fidelity: fidelities.includes(d.fidelity) ? d.fidelity : fidelities[0], filtered: model.rows, folder: sweep.folder };

  const extra = [...new Set([...objectives, ...["cycles_per_frame", "fps", "energy.frame_uj", "bottleneck"].filter((name) => sweep.columns.includes(name))])].filter((name) => !model.parameters.includes(name));
  const column = (key) => ({ key, label: key, num: model.numeric.includes(key), downFirst: true });
  const shown = ["point", ...(scenes.length > 1 ? ["scene"] : []), ...(fidelities.length > 1 ? ["fidelity"] : []), "status", ...model.parameters, ...extra].filter((name) => sweep.columns.includes(name));
  const tablePlace = h("div"), more = choice("add a column", [["", ""], ...sweep.columns.filter((name) => !shown.includes(name)).map((name) => [name, name])], "", (name) => { if (name && !shown.includes(name)) { shown.push(name); buildTable(); } });
  let table = null, building = false;
  function buildTable() {
    building = true;
    table = dataTable("Points", shown.map(column), model.rows, { filter: true, filterBy: sweep.columns.map(column), limit: 100, tall: true, sort: "point", rowClass: (row) => (row === state.chosen ? "chosen" : null), choose: (row) => { state.chosen = row; update(); }, changed: (rows) => { state.filtered = rows; if (!building) charts_(); } });
    building = false;
    clear(tablePlace).append(table.element);
  }

  const parts = [frontSection(model, state, update), parallelSection(model, state, update), effectsSection(model, state, update)];
  function charts_() {
    const kept = new Set(state.filtered);
    state.all = model.rows.filter((row) => row.status === "ok" && row.scene === state.scene && row.fidelity === state.fidelity);
    const places = Object.fromEntries(Object.keys(state.brushes).map((name) => [name, placer(state.all, name).place]));
    state.rows = state.all.filter((row) => kept.has(row) && Object.entries(state.brushes).every(([name, [low, high]]) => { const p = places[name](row[name]); return p !== null && p >= low - 1e-9 && p <= high + 1e-9; }));
    for (const part of parts) part.draw();
    count.textContent = `${number(state.rows.length)} of ${number(state.all.length)} points are in the charts.`;
  }
  function update() { charts_(); building = true; table.draw(); building = false; }
  const count = h("p", { class: "soft", role: "status", id: "point-count" });

  const statusRows = Object.entries(model.rows.reduce((all, row) => { const key = `${row.status}, ${row.fidelity}`; all[key] = (all[key] || 0) + 1; return all; }, {})).map(([status, points]) => ({ status, points }));
  const bad = model.rows.filter((row) => row.status !== "ok").length;
  const summary = section("summary", "Summary",
    h("div", { class: "tiles" }, tile(number(model.rows.length), "points"), tile(String(d.design && d.design.kind || "–"), "design"), tile(number(model.parameters.length), "varied parameters"), tile(number(scenes.length), scenes.length === 1 ? "scene" : "scenes"), tile(fidelities.join(", "), "fidelity")),
    bad > 0 && note("warn", `${bad} points have no result or a bad one: their status says which. They are in the table and not in the charts.`),
    d.screen && note("", `Screened with ${d.screen.fidelity}, the front confirmed with ${d.fidelity}: figures of the two are never in one chart.`),
    h("div", { class: "two" }, h("div", {}, h("h3", {}, "Parameters"), dataTable("Varied parameters", [{ key: "path", label: "parameter", long: true }, { key: "values", label: "values", long: true }, { key: "unit", label: "unit" }, { key: "default", label: "default" }],
      d.parameters.map((p) => ({ path: p.path, unit: p.unit, default: parameterText(p.default), values: [...new Set(model.rows.map((row) => row[p.path]))].filter((v) => v !== null && v !== undefined).sort(compareValues) })).map((p) => ({ ...p, values: p.values.length > 8 ? `${valueText(p.values[0])} … ${valueText(p.values[p.values.length - 1])}, ${p.values.length} values` : p.values.map(valueText).join(", ") }))).element),
      h("div", {}, h("h3", {}, "Points"), dataTable("Points by status", [{ key: "status", label: "status, fidelity" }, { key: "points", label: "points", num: true }], statusRows).element)),
    h("div", { class: "bar" }, scenes.length > 1 && choice("scene", scenes.map((name) => [name, name]), state.scene, (v) => { state.scene = v; state.brushes = {}; charts_(); }).element, fidelities.length > 1 && choice("fidelity", fidelities.map((name) => [name, name]), state.fidelity, (v) => { state.fidelity = v; charts_(); }).element), count);
  buildTable();
  const points = section("points", "All points", h("p", { class: "soft" }, "The filter holds for the charts, too: words, or comparisons such as ", command(`${model.parameters[0] || "point"}>=${valueText(model.rows[0] && model.rows[0][model.parameters[0] || "point"])}`), "."), h("div", { class: "bar" }, more.element), tablePlace);
  charts_();
  return { title: `${sweep.name}: ${number(model.rows.length)} points`, below: `A sweep over ${model.parameters.join(", ")}`, sections: [summary, parts[0].element, parts[1].element, parts[2].element, points] };
}
