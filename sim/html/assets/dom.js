// Elements, numbers as text, and a tooltip. Text only ever gets in as text: no name can become markup.
const SVG = "http://www.w3.org/2000/svg";

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes || {})) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name === "style") Object.assign(element.style, value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  for (const child of children.flat(Infinity)) {
    if (child !== undefined && child !== null && child !== false) element.append(child);
  }
  return element;
}
const h = (tag, attributes, ...children) => fill(document.createElement(tag), attributes, children);
const s = (tag, attributes, ...children) => fill(document.createElementNS(SVG, tag), attributes, children);
const clear = (element) => { while (element.firstChild) element.firstChild.remove(); return element; };

const isNumber = (x) => typeof x === "number" && Number.isFinite(x);
/** 1234567 -> "1,234,567", 0.01234567 -> "0.01235". */
function number(x) {
  if (!isNumber(x)) return "–";
  if (Number.isInteger(x)) return x.toLocaleString("en-US");
  const size = Math.abs(x);
  if (size >= 1000) return x.toLocaleString("en-US", { maximumFractionDigits: 1 });
  if (size >= 0.001) return String(Number(x.toPrecision(4)));
  return x.toExponential(2);
}
/** Of an axis: 1500000 -> "1.5M". */
function short(x) {
  const size = Math.abs(x);
  for (const [limit, letter] of [[1e12, "T"], [1e9, "G"], [1e6, "M"], [1e3, "k"]]) {
    if (size >= limit) return Number((x / limit).toPrecision(3)) + letter;
  }
  return size !== 0 && size < 1e-3 ? x.toExponential(0) : String(Number(x.toPrecision(3)));
}
const percent = (x) => (isNumber(x) ? (100 * x).toFixed(1) + " %" : "–");
const ratio = (a, b) => (b ? a / b : 0);
const sum = (values) => values.reduce((a, b) => a + b, 0);
const words = (name) => name.replace(/_/g, " ");

const tip = h("div", { class: "tip hidden", role: "status" });
function showTip(text, x, y) {
  tip.textContent = text;
  tip.classList.remove("hidden");
  const box = tip.getBoundingClientRect();
  tip.style.left = Math.max(4, Math.min(x + 14, innerWidth - box.width - 4)) + "px";
  tip.style.top = (y + box.height + 22 > innerHeight ? Math.max(4, y - box.height - 12) : y + 18) + "px";
}
const hideTip = () => tip.classList.add("hidden");
/** The element says `text()` when pointed at, and when it gets the focus. */
function tipped(element, text) {
  element.addEventListener("pointermove", (e) => showTip(text(), e.clientX, e.clientY));
  element.addEventListener("pointerleave", hideTip);
  element.addEventListener("focus", () => {
    const box = element.getBoundingClientRect();
    if (element.matches(":focus-visible")) showTip(text(), box.left + 40, box.top + 8);
  });
  element.addEventListener("blur", hideTip);
  return element;
}

function section(id, title, ...children) {
  return h("section", { id, "aria-labelledby": id + "-title" }, h("h2", { id: id + "-title" }, title), ...children);
}
const note = (kind, ...children) => h("p", { class: "note " + kind }, ...children);
const command = (text) => h("code", {}, text);

/** A drop-down: options are [value, label]. */
function choice(label, options, value, change) {
  const select = h("select", {}, options.map(([v, text]) => h("option", { value: v }, text)));
  select.value = value;
  select.addEventListener("change", () => change(select.value));
  return { element: h("label", {}, h("span", {}, label), select), select };
}
