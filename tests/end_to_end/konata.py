"""Reads a Kanata log that artu has written: python3 konata.py LOG STATS.json WHOLE

Written from the format's description alone.  Every instruction that begins retires, in stages that can follow one
another and leave no gap; with WHOLE = 1 there is one a ray of stats.json, and together they were in flight as long as
the contexts of the cores.  The first thing that is wrong ends the program with code 1.
"""

import collections
import json
import sys

# A ray whose leaf is tested passes traversal in no time.
STEPS = "Nf Qi Qh Qs"
FOLLOWS = {
    "Su": "Qt Tr", "Qt": "Tr " + STEPS, "Tr": STEPS, "Nf": "Tr", "Qi": "In Tf", "In": "Tf Qt Tr " + STEPS, "Tf": "In",
    "Qh": "Hp Sf", "Sf": "Hp", "Hp": "Sf Qs Sh Xf", "Qs": "Sh Xf", "Xf": "Sh", "Sh": "Xf Qg", "Qg": ""}
LAST = ("Sh", "Qg")


def check(holds, what):
    if not holds:
        sys.exit(what)


def main():
    lines = open(sys.argv[1], encoding="ascii").read().split("\n")
    totals = json.load(open(sys.argv[2]))["totals"]
    whole = sys.argv[3] == "1"
    check(lines[0] == "Kanata\t0004", "not a Kanata log")
    check(lines[1].startswith("C=\t") and lines[-1] == "", "no cycle, or no line end")
    first = cycle = int(lines[1][3:])
    live, numbers, retired, flushed, last_id = {}, {}, 0, 0, -1
    arrows, in_flight, stages = 0, 0, collections.Counter()
    for line in lines[2:-1]:
        kind, *words = line.split("\t")
        if kind == "C":
            check(len(words) == 1 and int(words[0]) > 0, line)
            cycle += int(words[0])
            continue
        check(kind in "ILWSER" and len(words) == 3, f"no command: {line}")
        number = int(words[0])
        if kind == "I":
            last_id += 1
            check(number == last_id, f"{number} after {last_id - 1}")
            check(int(words[2]) < 64 and words[1] not in numbers, line)
            numbers[words[1]] = number
            live[number] = {"begin": cycle, "stage": None, "since": cycle, "end": None, "label": None}
            continue
        check(number in live, f"{line}: it has not begun, or has retired")
        ray = live[number]
        if kind == "L":
            ray["label"] = ray["label"] or words[2]
        elif kind == "W":
            check(int(words[1]) < number and words[2] == "0", line)
            arrows += 1
        elif kind == "S":
            check(ray["stage"] is None, f"{line}: still in {ray['stage']}")
            if ray["end"] is not None:
                check(words[2] in FOLLOWS[ray["end"]].split(), f"{line}: {words[2]} after {ray['end']}")
                check(ray["since"] == cycle, f"{line}: a gap before it")
            elif first != cycle:
                check(words[2] == "Su", f"{line}: begins with {words[2]}")
            ray["stage"], ray["since"] = words[2], cycle
        elif kind == "E":
            check(ray["stage"] == words[2], f"{line}: in {ray['stage']}")
            check(cycle > ray["since"] or (cycle == first), f"{line}: it took no time")
            stages[words[2]] += cycle - ray["since"]
            ray["stage"], ray["end"], ray["since"] = None, words[2], cycle
        elif kind == "R":
            check(ray["stage"] is None and ray["since"] == cycle and ray["label"], line)
            if words[2] == "0":
                check(ray["end"] in LAST, f"{line}: ends in {ray['end']}")
                check(int(words[1]) == retired, f"{line}: after {retired}")
                retired += 1
            else:
                check(words[2] == "1", line)
                flushed += 1
            in_flight += cycle - ray["begin"]
            del live[number]
    check(not live, f"{len(live)} never retire")
    check(sum(stages.values()) == in_flight, "stages leave gaps")
    if whole:
        rays = totals["rays"]
        check(first == 0 and flushed == 0 and cycle <= totals["cycles"], "not the whole frame")
        check(retired == sum(rays.values()), f"{retired} rays of {sum(rays.values())}")
        check(arrows == retired - rays["primary"], f"{arrows} arrows")
        # A context is free when the generator has got it back, a cycle later at least.
        counted = sum(b["context_cycles"] for n, b in totals["blocks"].items() if n.endswith(".ray_generator"))
        check(0 <= counted - in_flight - rays["primary"] <= counted // 100, f"{in_flight} cycles of {counted}")
    print(f"{retired} retired, {flushed} flushed, {arrows} arrows; cycles in " +
          ", ".join(f"{name} {count}" for name, count in sorted(stages.items())))


main()
