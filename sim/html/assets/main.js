// Puts the page together.
function build() {
  const data = JSON.parse(document.getElementById("data").textContent);
  const page = data.kind === "sweep" ? sweepPage(data) : data.kind === "run" ? runPage(data.runs[0]) : comparisonPage(data);
  const sections = page.sections.filter(Boolean);
  const links = sections.map((part) => h("li", {}, h("a", { href: "#" + part.id }, part.firstChild.textContent)));
  clear(document.getElementById("page")).append(
    h("header", { class: "top" }, h("div", {}, h("h1", {}, page.title), h("div", { class: "soft" }, page.below)), themeButton()),
    h("nav", { "aria-label": "Sections" }, h("ul", {}, links)),
    h("main", { id: "main", tabindex: -1 }, sections),
    h("footer", {}, `Made by artu ${data.version} report. Nothing in this file is fetched from anywhere.`), tip);
}
try {
  build();
} catch (error) {
  document.getElementById("page").append(h("main", { id: "main" }, note("bad", "This page cannot be drawn: " + error.message)));
  throw error;
}
