"""report_browser.py KIND FILE.html: opens a report in a headless Chromium and uses it; exit code 1 says what is wrong.

KIND is what the page must be: run, comparison, table or sweep.
"""

import sys

from browser import Browser

wrong = []


def expect(true, what):
    if not true:
        wrong.append(what)
        print("wrong:", what)


DRAWN = """[...document.querySelectorAll('.chart')].map((chart) => {
  const box = chart.getBoundingClientRect();
  const marks = [...chart.querySelectorAll('svg rect, svg path, svg circle, canvas')].filter((m) => { const b = m.getBoundingClientRect(); return b.width > 0 && b.height > 0; });
  return {label: chart.getAttribute('aria-label'), width: box.width, height: box.height, marks: marks.length};
})"""
# Elements that can be worked but have no name that could be read out.
NAMELESS = """[...document.querySelectorAll('button, input, select, [tabindex="0"], svg [role]')].filter((e) =>
  !(e.textContent.trim() || e.getAttribute('aria-label') || e.labels?.length)).map((e) => e.outerHTML.slice(0, 80))"""
WIDE = "[...document.querySelectorAll('body *')].filter((e) => e.getBoundingClientRect().right > innerWidth + 1 && !e.closest('.scroll, .stage, nav')).map((e) => e.tagName + '.' + e.className).slice(0, 5)"
# The least contrast of a text with what is behind it (WCAG 2.1, 1.4.3: 4.5).
CONTRAST = """(() => {
  const parse = (c) => c.match(/[\\d.]+/g).map(Number);
  const light = (c) => { const [r, g, b] = c.slice(0, 3).map((v) => { v /= 255; return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; }); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  let worst = [99, ''];
  for (const e of document.querySelectorAll('h1, h2, h3, p, td, th, a, button, select, .soft, .tile span, li')) {
    if (!e.textContent.trim() || !e.getBoundingClientRect().width) continue;
    let behind = e, c = null;
    while (behind) { c = parse(getComputedStyle(behind).backgroundColor); if (c.length < 4 || c[3] > 0) break; behind = behind.parentElement; }
    if (!behind) continue;
    const a = light(parse(getComputedStyle(e).color)), b = light(c), ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (ratio < worst[0]) worst = [ratio, e.tagName + '.' + e.className + ' ' + e.textContent.slice(0, 30)];
  }
  return worst;
})()"""


def well_made(browser, file):
    """Any page, at both widths, dark and light."""
    for width in (1280, 360):
        for dark in (False, True):
            where = f"{width} px, {'dark' if dark else 'light'}: "
            browser.open(file, width=width, dark=dark)
            charts = browser.evaluate(DRAWN)
            expect(charts, where + "there are charts")
            for chart in charts:
                expect(chart["width"] > 100 and chart["height"] > 10 and chart["marks"] > 0, f"{where}chart drawn: {chart}")
            expect(browser.evaluate("document.documentElement.scrollWidth <= innerWidth"), where + "no sideways scrolling")
            expect(browser.evaluate(WIDE) == [], f"{where}nothing sticks out: {browser.evaluate(WIDE)}")
            expect(browser.evaluate(NAMELESS) == [], f"{where}all controls have names: {browser.evaluate(NAMELESS)}")
            contrast = browser.evaluate(CONTRAST)
            expect(contrast[0] >= 4.5, f"{where}contrast {contrast}")
            expect(browser.evaluate("getComputedStyle(document.body).backgroundColor") == ("rgb(14, 17, 22)" if dark else "rgb(246, 247, 249)"), where + "colours as the system says")
            expect(browser.evaluate("document.querySelectorAll('h1').length") == 1, where + "one h1")
            requests = browser.requests()
            expect(len(requests) == 1, f"{where}nothing but the page is asked for: {requests}")
            expect(browser.complaints() == [], f"{where}no errors: {browser.complaints()}")
    browser.click("#theme")
    expect(browser.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(246, 247, 249)", "the toggle makes it light")
    expect(browser.evaluate("window.hostile") is None, "no name became a script")


def filters(browser, table, text, left):
    """The table's filter leaves the rows that `left` (JavaScript, of a row's text) says."""
    browser.evaluate(f"document.querySelector('{table} input[type=search]').focus()")
    browser.type(text)
    browser.settle()
    rows = browser.evaluate(f"[...document.querySelectorAll('{table} tbody tr')].map((row) => row.textContent)")
    expect(rows, f"{table}: rows are left of \"{text}\"")
    expect(browser.evaluate(f"[...document.querySelectorAll('{table} tbody tr')].every((row) => ({left})(row))"), f"{table}: \"{text}\" leaves only {left}: {rows[:3]}")


def sorts(browser, table, column):
    """A click on the column's head sorts, a second one the other way round."""
    values = f"[...document.querySelectorAll('{table} tbody tr')].map((row) => parseFloat(row.children[{column}].textContent.replace(/,/g, '')))"
    head = f"{table} thead th:nth-child({column + 1})"
    sorted_now = f"document.querySelector('{head}').getAttribute('aria-sort')"
    orders = []
    for _ in range(2):
        before = browser.evaluate(sorted_now)
        for _ in range(5):  # a busy machine can move the page between a look at where the head is and the click
            browser.click(head + " button")
            if browser.evaluate(sorted_now) != before:
                break
        have = [v for v in browser.evaluate(values) if v is not None]
        orders.append("up" if have == sorted(have) else "down" if have == sorted(have, reverse=True) else "none")
    expect(sorted(orders) == ["down", "up"], f"{table}: column {column} sorts both ways: {orders}")


CHOOSE = """((label, value) => { const s = [...document.querySelectorAll('label')].find((l) => l.textContent.startsWith(label) && l.querySelector('select')).querySelector('select');
  s.value = value; s.dispatchEvent(new Event('change')); return s.value; })"""


def over_time(browser):
    pixels = "document.querySelector('#timeline canvas').toDataURL()"
    busy = browser.evaluate(pixels)
    expect(len(busy) > 1000, "the map over time has colours")
    browser.evaluate(CHOOSE + "('state', 'stall_mem')")
    expect(browser.evaluate(pixels) != busy, "another state is another map")
    whole = browser.evaluate("document.querySelectorAll('#cycles .chart')[1].textContent + document.querySelector('#cycles details').textContent")
    browser.evaluate(CHOOSE + "('phase', 'flush')")
    flush = browser.evaluate("document.querySelectorAll('#cycles .chart')[1].textContent + document.querySelector('#cycles details').textContent")
    expect(flush != whole and "100.0 %" in flush, "a phase has states of its own")
    expect(browser.evaluate("document.querySelectorAll('#visits svg rect').length") >= 1, "visits are drawn")


def sweep(browser, file):
    """Of the fixture in report_test.cpp: 24 points of scene a, in which b costs nothing, and others."""
    browser.open(file)
    front = "[...document.querySelectorAll('#front tbody tr')].map((row) => row.children[0].textContent)"
    expect(browser.evaluate(front) == ["1", "5", "9", "13", "17", "21"], f"the front: {browser.evaluate(front)}")
    expect(browser.evaluate("document.querySelectorAll('#front circle.front').length") == 6, "and its circles")
    expect(browser.evaluate("document.querySelectorAll('#front circle').length") == 24, "all points of the scene are drawn, those that failed are not")
    effects = browser.evaluate("[...document.querySelectorAll('#effects h3')].map((e) => e.textContent)")
    expect(len(effects) == 2 and effects[0].startswith("core.count"), f"what does most comes first: {effects}")
    lines = "document.querySelectorAll('#parallel svg > path').length"
    expect(browser.evaluate(lines) == 24, "a line a point")
    # One objective turned round: more cores are better.
    browser.evaluate("[...document.querySelectorAll('#front button')].find((b) => b.textContent === 'less is better').click()")
    expect(browser.evaluate(front) != ["1", "5", "9", "13", "17", "21"], "the front follows the goals")
    # A range on an axis, by dragging.
    browser.evaluate("document.querySelector('#parallel').scrollIntoView({block: 'center', behavior: 'instant'})")
    browser.settle()
    box = browser.evaluate("(() => { const b = document.querySelector('#parallel rect[data-axis=\"core.count\"]').getBoundingClientRect(); return [b.left + b.width / 2, b.top, b.height]; })()")
    for kind, share in (("mouseMoved", 0.98), ("mousePressed", 0.98), ("mouseMoved", 0.6), ("mouseReleased", 0.6)):
        browser.send("Input.dispatchMouseEvent", type=kind, x=box[0], y=box[1] + share * box[2], button="left", buttons=1, clickCount=1)
    browser.settle()
    left = browser.evaluate(lines)
    expect(0 < left < 24, f"a range on an axis leaves some: {left}")
    browser.open(file)
    filters(browser, "#points", "core.count>=4 b=2", "(row) => Number(row.querySelectorAll('td')[3].textContent) >= 4 && row.querySelectorAll('td')[4].textContent === '2'")
    expect(browser.evaluate(lines) == 3, f"the filter holds for the charts, too: {browser.evaluate(lines)}")
    browser.open(file)
    sorts(browser, "#points", 3)
    browser.evaluate(CHOOSE + "('scene', 'b.glb')")
    expect(browser.evaluate(lines) == 1, "the other scene")
    expect(browser.complaints() == [], f"no errors after all that: {browser.complaints()}")


OUTSIDE = """(() => {
  const svg = document.querySelector('#parallel svg').getBoundingClientRect();
  return [...document.querySelectorAll('#parallel svg text')].map((t) => [t.textContent, t.getBoundingClientRect()])
    .filter(([, b]) => b.left < svg.left - 1 || b.right > svg.right + 1).map(([text]) => text);
})()"""


def swept(browser, file):
    """Of a sweep that `artu sweep` has made: 2 x 3 points."""
    browser.open(file)
    expect(browser.evaluate("document.querySelectorAll('#points tbody tr').length") == 6, "a row a point")
    lines = browser.evaluate("document.querySelectorAll('#parallel svg > path').length")
    expect(lines == 6, f"a line a point: {lines}")
    expect(browser.evaluate("document.querySelectorAll('#front circle.front').length") >= 1, "a front")
    effects = browser.evaluate("[...document.querySelectorAll('#effects h3')].map((e) => e.textContent.split(':')[0]).sort()")
    expect(effects == ["accel.static.kind", "core.count"], f"the effect of each parameter: {effects}")
    for width in (1280, 360):
        browser.open(file, width=width)
        expect(browser.evaluate(OUTSIDE) == [], f"{width} px: nothing beside the axes is cut: {browser.evaluate(OUTSIDE)}")
    expect(browser.complaints() == [], f"no errors after all that: {browser.complaints()}")


def run(browser, file):
    browser.open(file)
    expect("cycles a frame" in browser.evaluate("document.getElementById('explanation').textContent"), "what binds the run is said")
    shown = "document.getElementById('picture-caption').textContent"
    picture = "document.querySelector('.stage img').src"
    first = browser.evaluate(picture)
    expect(browser.evaluate("document.querySelector('.stage img').naturalWidth > 0"), "the picture is decoded")
    # The slider by the keyboard, then the picture's own keys.
    browser.evaluate("document.getElementById('frame').focus()")
    browser.key("ArrowRight")
    expect(browser.evaluate(shown).startswith("frame 1:"), "the slider goes to the next frame: " + browser.evaluate(shown))
    if browser.evaluate("JSON.parse(document.getElementById('data').textContent).runs[0].stats.totals.triangles.dynamic") > 0:
        expect(browser.evaluate(picture) != first, "and shows another picture")
    browser.evaluate("document.querySelector('.stage').focus()")
    browser.key("ArrowLeft")
    expect(browser.evaluate(shown).startswith("frame 0:"), "left: the frame before")
    browser.key("ArrowDown")
    expect("full render" in browser.evaluate(shown), "down: the next kind of picture: " + browser.evaluate(shown))
    before = browser.evaluate("document.querySelector('.stage img').getBoundingClientRect().width")
    browser.evaluate("(() => { const s = [...document.querySelectorAll('#viewer select')].find((s) => s.textContent.includes('to fit')); s.value = '16'; s.dispatchEvent(new Event('change')); })()")
    after = browser.evaluate("[document.querySelector('.stage img').getBoundingClientRect().width, document.querySelector('.stage img').naturalWidth, getComputedStyle(document.querySelector('.stage img')).imageRendering]")
    expect(after[0] == 16 * after[1] and after[2] == "pixelated" and after[0] != before, f"zoom: {before} to {after}")
    # Another picture beside it.
    browser.evaluate("(() => { const s = [...document.querySelectorAll('#viewer select')].find((s) => s.textContent.includes('nothing')); s.value = '0'; s.dispatchEvent(new Event('change')); })()")
    expect(browser.evaluate("getComputedStyle(document.querySelector('.stage img.over')).clipPath").startswith("inset("), "the wipe cuts the upper picture")
    expect(len(browser.evaluate("[...document.querySelectorAll('#cycles .chart')].map((c) => c.querySelectorAll('svg').length)")) >= 2, "phases and blocks are drawn")
    filters(browser, "#numbers", "l2_bank0 hits", "(row) => row.textContent.includes('l2_bank0') && row.textContent.includes('hits')")
    browser.open(file)
    if browser.evaluate("JSON.parse(document.getElementById('data').textContent).runs[0].timeline !== null"):
        over_time(browser)
    filters(browser, "#numbers", "value>1000", "(row) => parseFloat(row.children[1].textContent.replace(/,/g, '')) > 1000")
    sorts(browser, "#numbers", 1)
    expect(browser.complaints() == [], f"no errors after all that: {browser.complaints()}")


def comparison(browser, file):
    browser.open(file)
    ratios = "[...document.querySelectorAll('#figures tbody tr')].map((row) => row.children[3].textContent)"
    rows = browser.evaluate(ratios)
    expect(rows and "1" not in rows, f"figures that are equal are hidden: {rows[:5]}")
    sizes = browser.evaluate("[...document.querySelectorAll('#figures tbody tr')].map((row) => { const [a, b] = [1, 2].map((i) => parseFloat(row.children[i].textContent.replace(/,/g, ''))); return a > 0 && b > 0 ? Math.abs(Math.log(b / a)) : 99; })")
    expect(all(a >= b - 0.01 for a, b in zip(sizes, sizes[1:])), f"the largest changes come first: {sizes[:8]}")
    left = "document.querySelector('#figures [role=status]').textContent"
    before = browser.evaluate(left)
    browser.click("#equal")
    expect(" of " in before and " of " not in browser.evaluate(left), f"the box shows equal ones, too: {before}, then {browser.evaluate(left)}")
    expect("core.count" in browser.evaluate("document.querySelector('#config').textContent"), "the configuration's difference is named")
    expect(browser.evaluate("document.querySelectorAll('#config tbody tr').length") == 1, "and no other")
    expect(browser.evaluate("document.getElementById('picture-caption').textContent.includes('|')"), "both pictures are shown")
    clip = "getComputedStyle(document.querySelector('.stage img.over')).clipPath"
    before = browser.evaluate(clip)
    browser.evaluate("document.getElementById('wipe').focus()")
    browser.key("ArrowRight")
    expect(browser.evaluate(clip) != before, "the wipe moves")
    browser.click("#turns")
    seen = browser.evaluate("new Promise((done) => { const seen = new Set(); const timer = setInterval(() => { seen.add(document.querySelector('.stage img.over').classList.contains('hidden')); }, 50); setTimeout(() => { clearInterval(timer); done(seen.size); }, 2000); })")
    expect(seen == 2, "in turns: one picture after the other")
    filters(browser, "#figures", "traversal", "(row) => row.textContent.includes('traversal')")
    expect(browser.complaints() == [], f"no errors after all that: {browser.complaints()}")


def table(browser, file):
    browser.open(file)
    heads = browser.evaluate("[...document.querySelectorAll('#main-figures thead th')].map((th) => th.textContent)")
    expect(len(heads) == 4 + 4, f"a column a run: {heads}")
    sorts(browser, "#main-figures", 1)
    expect(browser.complaints() == [], f"no errors after all that: {browser.complaints()}")


with Browser() as browser:
    kind, file = sys.argv[1:]
    well_made(browser, file)
    {"run": run, "comparison": comparison, "table": table, "sweep": sweep, "swept": swept}[kind](browser, file)
sys.exit(1 if wrong else 0)
