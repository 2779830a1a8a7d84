// Dark and light: as the system says, until somebody chooses.
function themeButton() {
  const dark = () => {
    const chosen = document.documentElement.dataset.theme;
    return chosen ? chosen === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  };
  const button = h("button", { type: "button", id: "theme" });
  const name = () => { button.textContent = dark() ? "Light colours" : "Dark colours"; };
  button.addEventListener("click", () => {
    document.documentElement.dataset.theme = dark() ? "light" : "dark";
    name();
    redrawCharts();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { name(); redrawCharts(); });
  name();
  return button;
}
/** What a CSS variable stands for now: canvases need the colour itself. */
const color = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
const series = (i) => `var(--s${i % 8})`;
