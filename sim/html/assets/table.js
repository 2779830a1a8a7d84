// A table that sorts by a click on a column's head and filters by words or comparisons.

/** "core.count>=4 sponza": words must occur in a row, comparisons hold for a column. Returns a test of a row. */
function rowFilter(text, columns) {
  const tests = text.trim().split(/\s+/).filter(Boolean).map((word) => {
    const m = /^(.+?)(<=|>=|!=|=|<|>)(.*)$/.exec(word);
    const column = m && columns.find((c) => c.key.toLowerCase() === m[1].toLowerCase());
    if (!column) { const part = word.toLowerCase(); return (row) => columns.some((c) => String(row[c.key] ?? "").toLowerCase().includes(part)); }
    const want = m[3], value = Number(want);
    return (row) => {
      const have = row[column.key];
      if (m[2] === "=" || m[2] === "!=") {
        const same = isNumber(have) && want !== "" && !Number.isNaN(value) ? have === value : String(have ?? "").toLowerCase() === want.toLowerCase();
        return same === (m[2] === "=");
      }
      if (want === "" || !isNumber(have) || Number.isNaN(value)) return false;
      return m[2] === "<" ? have < value : m[2] === ">" ? have > value : m[2] === "<=" ? have <= value : have >= value;
    };
  });
  return (row) => tests.every((test) => test(row));
}
function compareValues(a, b) {
  const none = (x) => x === undefined || x === null || x === "";
  if (none(a) || none(b)) return none(a) === none(b) ? 0 : none(a) ? 1 : -1;
  if (isNumber(a) && isNumber(b)) return a - b;
  return String(a).localeCompare(String(b), "en", { numeric: true });
}

/**
 * columns: [{key, label, num, title, text(row), cell(row)}], rows: objects.
 * Returns {element, filter(text), rows()}; `changed` is told of the rows that are left.
 */
function dataTable(caption, columns, rows, { filter = false, limit = 200, sort = null, down = false, tall = false, changed, rowClass, choose, filterBy = columns } = {}) {
  let by = sort, reverse = down, wanted = "", extra = null, most = limit, left = rows;
  const body = h("tbody"), more = h("div"), count = h("span", { class: "soft", role: "status" });
  const heads = columns.map((c) => {
    const th = h("th", { scope: "col", class: c.num ? "num" : null, title: c.title }, h("button", { type: "button" }, c.label));
    th.firstChild.addEventListener("click", () => { reverse = by === c.key ? !reverse : Boolean(c.num && c.downFirst); by = c.key; draw(); });
    return th;
  });
  function cell(c, row) {
    const content = c.cell ? c.cell(row) : c.text ? c.text(row) : isNumber(row[c.key]) ? number(row[c.key]) : row[c.key];
    return h("td", { class: c.num ? "num" : c.long ? "long" : null }, content ?? "–");
  }
  function draw() {
    left = rows.filter(rowFilter(wanted, filterBy));
    if (extra) left = left.filter(extra);
    if (by !== null) {
      left = left.map((row, i) => [row, i]).sort(([a, i], [b, j]) => {
        const empty = (r) => r[by] === undefined || r[by] === null || r[by] === "";
        const order = compareValues(a[by], b[by]);
        return (empty(a) || empty(b) ? order : reverse ? -order : order) || i - j;
      }).map(([row]) => row);
    }
    columns.forEach((c, i) => heads[i].setAttribute("aria-sort", c.key === by ? (reverse ? "descending" : "ascending") : "none"));
    clear(body);
    for (const row of left.slice(0, most)) {
      const tr = h("tr", { class: rowClass ? rowClass(row) : null }, columns.map((c) => cell(c, row)));
      if (choose) { tr.tabIndex = 0; tr.addEventListener("click", () => choose(row)); tr.addEventListener("keydown", (e) => { if (e.key === "Enter") choose(row); }); }
      body.append(tr);
    }
    clear(more);
    if (left.length > most) more.append(h("button", { type: "button", onclick: () => { most = Infinity; draw(); } }, `Show all ${number(left.length)} rows`));
    count.textContent = left.length === rows.length ? `${number(rows.length)} rows` : `${number(left.length)} of ${number(rows.length)} rows`;
    if (changed) changed(left);
  }
  const input = h("input", { type: "search", placeholder: "Filter", "aria-label": "Filter " + caption, autocomplete: "off", spellcheck: "false" });
  input.addEventListener("input", () => { wanted = input.value; draw(); });
  const table = h("table", {}, h("caption", { class: "sr" }, caption), h("thead", {}, h("tr", {}, heads)), body);
  const element = h("div", { class: "datatable" }, filter && h("div", { class: "bar" }, input, count),
    h("div", { class: "scroll" + (tall ? " tall" : ""), tabindex: 0, role: "region", "aria-label": caption }, table), more);
  draw();
  return { element, draw, rows: () => left, restrict(test) { extra = test; draw(); } };
}
