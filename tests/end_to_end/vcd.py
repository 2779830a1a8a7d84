"""Reads a value change dump that artu has written: python3 vcd.py TRACE STATS.json WHOLE [OTHER]

Written from IEEE 1364 alone.  With WHOLE = 1 the states of every block must add up to what stats.json says.  OTHER is a
dump in which every variable must change at the same times to the same values: the same after another program had it.
"""

import json
import sys


def check(holds, what):
    if not holds:
        sys.exit(what)


def read(name):
    """(timescale, {path: [(time, value)]}, last time)"""
    words = iter(open(name, encoding="ascii").read().split())
    scope, paths, widths, changes, time, scale = [], {}, {}, {}, None, ""

    def section():
        out = []
        for word in words:
            if word == "$end":
                return out
            out.append(word)
        sys.exit("a section without an end")

    for word in words:
        if word == "$scope":
            scope.append(section()[1])
        elif word == "$upscope":
            section()
            scope.pop()
        elif word == "$timescale":
            scale = "".join(section())
        elif word == "$var":
            var = section()
            path = ".".join(scope + [var[3]])
            check(var[2] not in paths and path not in changes, f"{path} is declared twice")
            paths[var[2]], widths[var[2]], changes[path] = path, int(var[1]), []
        elif word == "$enddefinitions":
            section()
            check(not scope, "scopes are open")
            break
        elif word in ("$version", "$comment", "$date", "$attrbegin", "$attrend"):
            section()
        else:
            sys.exit(f"{word} among the definitions")
    for word in words:
        if word[0] == "#":
            check(time is None or int(word[1:]) > time, f"{word} after #{time}")
            time = int(word[1:])
            continue
        if word in ("$dumpvars", "$end"):
            continue
        if word[0] == "b":
            bits, identifier = word[1:], next(words)
        else:
            bits, identifier = word[0], word[1:]
        check(identifier in paths, f"{word}: no such variable")
        check(len(bits) <= widths[identifier], f"{paths[identifier]}: {bits} is too wide")
        if "x" in bits:
            continue  # before the first value
        check(time is not None, "a value before the first time")
        changes[paths[identifier]].append((time, int(bits, 2)))
    return scale, changes, time


def main():
    scale, changes, end = read(sys.argv[1])
    totals = json.load(open(sys.argv[2]))["totals"]
    check(scale == "1ps", scale)
    blocks = {path[5:-6]: c for path, c in changes.items() if path.endswith(".state")}
    for path, values in changes.items():
        for (before, old), (after, new) in zip(values, values[1:]):
            check(before < after and old != new, f"{path}: {new} at {after} after {old} at {before}")
    if sys.argv[3] == "1":
        check(set(blocks) == set(totals["blocks"]), "not the blocks of the report")
        for name, values in blocks.items():
            counted = totals["blocks"][name]
            order = [counted[s] for s in ("busy", "stall_in", "stall_out", "stall_mem", "idle")]
            got = [0] * 5
            for (begin, state), (until, _) in zip(values, values[1:] + [(end, None)]):
                got[state] += until - begin
            for have, cycles in zip(got, order):
                check(abs(have * sum(order) / end - cycles) < 1, f"{name}: {got}, and the report has {order}")
        check(all(c[-1][1] == 0 for p, c in changes.items() if p.endswith(".level")), "a channel is not empty")
        check(end > 0 and all(c[0][0] == 0 for c in changes.values()), "not from the beginning")
    if len(sys.argv) > 4:
        other_scale, other, _ = read(sys.argv[4])
        check(other_scale == scale, f"{scale} became {other_scale}")
        check(set(other) == set(changes), "other variables")
        for path, values in changes.items():
            check(other[path] == values, f"{path} has changed")
    print(f"{len(blocks)} blocks, {len(changes)} variables, {sum(map(len, changes.values()))} changes")


main()
