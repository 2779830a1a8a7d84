// Charts as SVG, drawn again whenever their width changes.
const charts = new Set();
const observer = new ResizeObserver((entries) => {
  for (const entry of entries) {
    const chart = entry.target.chart, width = Math.floor(entry.contentRect.width);
    if (chart && width > 0 && width !== chart.width) { chart.width = width; chart.draw(width); }
  }
});
function redrawCharts() { for (const chart of charts) if (chart.width > 0) chart.draw(chart.width); }

/** `draw(place, width)` fills the place, which is empty. */
function chart(label, draw, kind = "chart") {
  const place = h("div", { class: kind, role: "group", "aria-label": label });
  place.chart = { width: 0, draw: (width) => draw(clear(place), width) };
  charts.add(place.chart);
  observer.observe(place);
  place.redraw = () => { if (place.chart.width > 0) place.chart.draw(place.chart.width); };
  return place;
}

/** Round values between low and high, about `count` of them. */
function ticks(low, high, count) {
  if (!(high > low)) return [low];
  const raw = (high - low) / Math.max(1, count), power = Math.pow(10, Math.floor(Math.log10(raw)));
  const step = [1, 2, 2.5, 5, 10].find((m) => m * power >= raw * 0.999) * power;
  const values = [];
  for (let v = Math.ceil(low / step - 1e-9) * step; v <= high + step * 1e-6; v += step) values.push(Math.abs(v) < step * 1e-9 ? 0 : v);
  return values;
}
const scale = (low, high, from, to) => (v) => from + (high === low ? 0.5 : (v - low) / (high - low)) * (to - from);

const legend = (entries) =>
  h("ul", { class: "legend" }, entries.map(([name, fillColor]) => h("li", {}, h("i", { style: { background: fillColor } }), name)));

/** Horizontal stacked bars. rows: [{label, parts: [{name, value, fill}], total, note}]; total: what the whole width is. */
function stackChart(label, rows, { height = 17, text = number, choose } = {}) {
  return chart(label, (place, width) => {
    const narrow = width < 560, left = narrow ? 0 : Math.min(230, width * 0.28), right = narrow ? 0 : 4;
    const step = narrow ? height + 23 : height + 7, current = typeof rows === "function" ? rows() : rows;
    const svg = s("svg", { viewBox: `0 0 ${width} ${current.length * step + 4}`, height: current.length * step + 4 });
    current.forEach((row, i) => {
      const y = i * step + 2, at = narrow ? y + 17 : y, total = row.total || 1;
      const says = () => [row.label, ...row.parts.filter((p) => p.value > 0).map((p) => `${words(p.name)}: ${text(p.value)} (${percent(p.value / total)})`), row.note].filter(Boolean).join("\n");
      const group = s("g", { class: "row", tabindex: 0, role: choose ? "button" : "img", "aria-label": says().replace(/\n/g, ", ") },
        s("rect", { class: "back", x: 0, y: y - 2, width, height: step - 2, fill: "transparent", rx: 3 }),
        s("text", { x: narrow ? 2 : left - 8, y: narrow ? y + 11 : y + height - 4, "text-anchor": narrow ? "start" : "end" }, cut(row.label, narrow ? width - 70 : left - 12)));
      let x = left;
      for (const part of row.parts) {
        const w = (part.value / total) * (width - left - right);
        if (w > 0) group.append(s("rect", { x, y: at, width: Math.max(w, 0.5), height, fill: part.fill }));
        x += w;
      }
      if (row.value !== undefined) group.append(s("text", { class: "soft", x: narrow ? width - 2 : Math.min(x + 6, width - 2), y: narrow ? y + 11 : y + height - 4, "text-anchor": narrow || x + 80 > width ? "end" : "start" }, row.value));
      if (choose) {
        group.addEventListener("click", () => choose(row));
        group.addEventListener("keydown", (e) => { if (e.key === "Enter" || e.key === " ") { e.preventDefault(); choose(row); } });
      }
      svg.append(tipped(group, says));
    });
    place.append(svg);
  });
}
/** A label that is too long for `width` pixels ends in dots. */
function cut(text, width) {
  const letters = Math.max(4, Math.floor(width / 6.6)), all = [...text];
  return all.length <= letters ? text : all.slice(0, letters - 1).join("") + "…";
}

/** Axes of a chart of `width` x `height`; returns the two scales and the SVG. */
function axes(place, width, height, { x, y, marks = [] }) {
  const left = 52, right = 10, top = 10, bottom = 38;
  const svg = s("svg", { viewBox: `0 0 ${width} ${height}`, height });
  const map = (axis, from, to) => axis.log
    ? ((f) => (v) => f(Math.log10(v)))(scale(Math.log10(axis.low), Math.log10(axis.high), from, to)) : scale(axis.low, axis.high, from, to);
  const X = map(x, left, width - right), Y = map(y, height - bottom, top);
  const values = (axis, count) => axis.log ? decades(axis.low, axis.high) : ticks(axis.low, axis.high, count);
  for (const v of values(y, 5)) {
    svg.append(s("line", { class: "grid", x1: left, x2: width - right, y1: Y(v), y2: Y(v) }), s("text", { class: "soft", x: left - 6, y: Y(v) + 4, "text-anchor": "end" }, short(v)));
  }
  for (const v of x.values || values(x, Math.max(3, Math.floor(width / 100)))) {
    svg.append(s("line", { class: "axis", x1: X(v), x2: X(v), y1: height - bottom, y2: height - bottom + 4 }), s("text", { class: "soft", x: X(v), y: height - bottom + 17, "text-anchor": "middle" }, x.text ? x.text(v) : short(v)));
  }
  for (const mark of marks) {
    svg.append(s("line", { class: "mark", x1: X(mark.x), x2: X(mark.x), y1: top, y2: height - bottom }), s("text", { class: "soft", x: X(mark.x) + (X(mark.x) > width - 80 ? -3 : 3), y: top + 9, "text-anchor": X(mark.x) > width - 80 ? "end" : "start" }, mark.label));
  }
  svg.append(s("line", { class: "axis", x1: left, x2: width - right, y1: height - bottom, y2: height - bottom }),
    s("text", { class: "soft", x: (left + width - right) / 2, y: height - 4, "text-anchor": "middle" }, x.label || ""));
  if (y.label) place.append(h("div", { class: "soft" }, y.label));
  place.append(svg);
  return { svg, X, Y, left, right, top, bottom: height - bottom };
}
function decades(low, high) {
  const values = [];
  for (let e = Math.floor(Math.log10(low)); e <= Math.ceil(Math.log10(high)); ++e) values.push(Math.pow(10, e));
  const inside = values.filter((v) => v >= low * 0.999 && v <= high * 1.001);
  return inside.length >= 2 ? inside : [low, high];
}

/** lines: [{name, points: [[x, y]], fill}]; steps: a value holds until the next one. */
function lineChart(label, lines, { x = {}, y = {}, marks = () => [], height = 230, steps = false, text = number } = {}) {
  const shown = new Set();
  const current = () => (typeof lines === "function" ? lines() : lines);
  const place = chart(label, (inside, width) => {
    const all = current(), drawn = all.filter((line) => !shown.has(line.name));
    const points = drawn.flatMap((line) => line.points);
    if (!points.length) { inside.append(h("p", { class: "soft" }, "Nothing to draw.")); return; }
    const xs = points.map((p) => p[0]), ys = points.map((p) => p[1]);
    const low = Math.min(...xs), high = Math.max(...xs), top = Math.max(...ys, 0);
    const frame = axes(inside, width, height, {
      x: { ...x, low: x.low ?? low, high: Math.max(x.high ?? high, low + 1e-9) },
      y: { ...y, low: 0, high: y.high ?? (top > 0 ? top * 1.05 : 1) }, marks: marks() });
    for (const line of drawn) {
      let path = "";
      line.points.forEach(([px, py], i) => {
        const X = frame.X(px).toFixed(1), Y = frame.Y(py).toFixed(1);
        path += i === 0 ? `M${X},${Y}` : steps ? `H${X}V${Y}` : `L${X},${Y}`;
      });
      frame.svg.append(s("path", { d: path, fill: "none", stroke: line.fill, "stroke-width": 1.8, "stroke-linejoin": "round" }));
      if (line.points.length <= 40 && !steps) for (const [px, py] of line.points) frame.svg.append(s("circle", { cx: frame.X(px), cy: frame.Y(py), r: 2.5, fill: line.fill }));
    }
    const cursor = s("line", { class: "mark hidden", y1: frame.top, y2: frame.bottom });
    const area = s("rect", { x: frame.left, y: frame.top, width: Math.max(1, width - frame.left - frame.right), height: frame.bottom - frame.top, fill: "transparent" });
    area.addEventListener("pointermove", (e) => {
      const box = frame.svg.getBoundingClientRect(), at = e.clientX - box.left;
      const nearest = (line) => line.points.reduce((a, b) => (Math.abs(frame.X(b[0]) - at) < Math.abs(frame.X(a[0]) - at) ? b : a));
      const first = nearest(drawn[0]);
      cursor.setAttribute("x1", frame.X(first[0])); cursor.setAttribute("x2", frame.X(first[0])); cursor.classList.remove("hidden");
      showTip([`${x.label || "x"} ${x.text ? x.text(first[0]) : number(first[0])}`, ...drawn.map((line) => `${line.name}: ${text(nearest(line)[1])}`)].join("\n"), e.clientX, e.clientY);
    });
    area.addEventListener("pointerleave", () => { hideTip(); cursor.classList.add("hidden"); });
    frame.svg.append(cursor, area);
  });
  const names = current();
  if (names.length < 2) return place;
  return h("div", {}, h("ul", { class: "legend" }, names.map((line) => {
    const button = h("button", { type: "button", "aria-pressed": "true" }, h("i", { style: { background: line.fill } }), line.name);
    button.addEventListener("click", () => {
      if (shown.has(line.name)) shown.delete(line.name); else shown.add(line.name);
      button.setAttribute("aria-pressed", String(!shown.has(line.name)));
      place.redraw();
    });
    return h("li", {}, button);
  })), place);
}
