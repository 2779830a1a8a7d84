"""Reads a Perfetto trace that artu has written: python3 perfetto.py TRACE STATS.json WHOLE

Written from the format's description alone, as a check on the writer: wire format, nesting of slices, counters within
their capacity, flows that begin and end.  With WHOLE = 1 the trace is of the whole frame, and slices must add up to
what stats.json says.  Prints a summary; the first thing that is wrong ends the program with code 1.
"""

import collections
import json
import sys


def varint(data, at):
    value = shift = 0
    while True:
        byte = data[at]
        at += 1
        value |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            return value, at


def fields(data):
    """(number, value) of a message: integers, or bytes."""
    at = 0
    while at < len(data):
        key, at = varint(data, at)
        number, kind = key >> 3, key & 7
        if kind == 0:
            value, at = varint(data, at)
        elif kind == 1:
            value, at = int.from_bytes(data[at:at + 8], "little"), at + 8
        elif kind == 2:
            length, at = varint(data, at)
            value, at = data[at:at + length], at + length
        else:
            sys.exit(f"field {number} of wire type {kind}")
        if at > len(data):
            sys.exit("a field goes beyond its message")
        yield number, value


def message(data):
    out = collections.defaultdict(list)
    for number, value in fields(data):
        out[number].append(value)
    return out


def check(holds, what):
    if not holds:
        sys.exit(what)


def main():
    data = open(sys.argv[1], "rb").read()
    totals = json.load(open(sys.argv[2]))["totals"]
    whole = sys.argv[3] == "1"
    names, tracks, stacks, last = {}, {}, {}, {}
    lengths = collections.defaultdict(lambda: collections.Counter())
    levels, flows, ended, instants, first_time, last_time = {}, {}, set(), 0, None, 0
    for number, packet in fields(data):
        check(number == 1, "something that is no packet")
        packet = message(packet)
        check(packet[10] == [1], "a packet of another sequence")
        for interned in packet[12]:
            check(packet[13] == [1], "interned names do not begin the sequence")
            for name in message(interned)[2]:
                name = message(name)
                names[name[1][0]] = name[2][0].decode()
        for descriptor in packet[60]:
            d = message(descriptor)
            uuid = d[1][0]
            check(uuid not in tracks, f"track {uuid} is described twice")
            parent = d[5][0] if 5 in d else None
            check(parent is None or parent in tracks, f"track {uuid} before its parent")
            capacity = int(message(d[8][0])[6][0].decode().split()[1]) if 8 in d else None
            tracks[uuid] = (d[2][0].decode(), parent, capacity)
            stacks[uuid], last[uuid] = [], 0
        for event in packet[11]:
            check(packet[13] == [2], "an event that does not ask for the interned names")
            e, time = message(event), packet[8][0]
            first_time = time if first_time is None else min(first_time, time)
            last_time = max(last_time, time)
            kind, track = e[9][0], e[11][0]
            check(track in tracks, f"an event of track {track}, which is not described")
            check(time >= last[track], f"{tracks[track]} goes back in time")
            last[track] = time
            if kind == 1:
                stacks[track].append((names[e[10][0]], time))
                check(len(stacks[track]) <= 2, f"{tracks[track]}: more than a state in a phase")
            elif kind == 2:
                check(stacks[track], f"{tracks[track]}: the end of nothing")
                name, begin = stacks[track].pop()
                lengths[track][name] += time - begin
            elif kind == 3:
                instants += 1
                check(len(stacks[track]) == 2, f"{tracks[track]}: a ray outside a state at {time}")
                for flow in e[47]:
                    check(flow not in ended, f"flow {flow} goes on after its end")
                    if flow not in flows:
                        check(len(e[4]) == 3, f"flow {flow} begins without its ray's number and pixel")
                    check(time >= flows.get(flow, 0), f"flow {flow} goes back in time")
                    flows[flow] = time
                for flow in e[48]:
                    check(flow in flows and flow not in ended, f"flow {flow} ends without a beginning")
                    ended.add(flow)
            elif kind == 4:
                name, _, capacity = tracks[track]
                value = e[30][0]
                check(capacity is not None and value <= capacity, f"{name}: {value} of {capacity}")
                levels[track] = value
            else:
                sys.exit(f"an event of type {kind}")
    check(not any(stacks.values()), "slices without an end")
    check(set(flows) == ended, "flows without an end")

    def path(track):
        name, parent, _ = tracks[track]
        owner = tracks[parent][0]
        return name if owner == "unit" else f"{owner}.{name}"

    blocks = {path(t): lengths[t] for t, (_, p, c) in tracks.items() if c is None and p and tracks[p][0] != tracks[1][0]}
    blocks = {name: times for name, times in blocks.items() if name in totals["blocks"]}
    states = ("busy", "stall_in", "stall_out", "stall_mem", "idle")
    if whole:
        check(set(blocks) == set(totals["blocks"]), "not the blocks of the report")
        check(first_time == 0 and last_time == 1000 * totals["cycles"], "not the whole frame")
        for name, times in blocks.items():
            counted = totals["blocks"][name]
            clocks = sum(counted[s] for s in states)
            for state in states:
                # A clock of the DRAM is not a whole number of nanoseconds: its edges are rounded down.
                got = times[state] * clocks / last_time if name == "dram" else times[state] / 1000
                check(round(got) == counted[state] and abs(got - counted[state]) < (1 if name == "dram" else 1e-9),
                      f"{name}: {got} cycles of {state}, and the report has {counted[state]}")
        phases = lengths[next(t for t, (name, _, _) in tracks.items() if name == "phase")]
        for phase in ("start", "build", "first", "selective", "flush"):
            counted = totals["blocks"]["control_unit"][f"cycles_{phase}"]
            check(phases[phase] == 1000 * counted, f"phase {phase}: {phases[phase]} ns, {counted} cycles")
        check(all(value == 0 for value in levels.values()), "a channel is not empty at the end")
        check(len(flows) == sum(totals["rays"].values()), "not a flow a ray")
    for name, times in blocks.items() if first_time is not None else ():
        check(sum(times[s] for s in states) == last_time - first_time, f"{name}: its slices leave gaps")
    print(f"{len(blocks)} blocks, {len(levels)} channels, {len(flows)} flows, {instants} visits")


main()
