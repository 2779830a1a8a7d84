#!/usr/bin/env python3
"""Writes hw/datapath/srgb_tables.inc from the sRGB curve in 60-digit arithmetic (docs/arithmetic.md, 6 and 8)."""
import pathlib
import struct
import sys
from decimal import Decimal, getcontext
from fractions import Fraction

if sys.argv[1:]:  # it takes none
    print(__doc__, file=sys.stderr)
    sys.exit(0 if sys.argv[1:] == ["--help"] else 2)

getcontext().prec = 60


def curve(c):
    c = Decimal(c.numerator) / Decimal(c.denominator)
    if c <= Decimal("0.04045"):
        return c / Decimal("12.92")
    return ((c + Decimal("0.055")) / Decimal("1.055")) ** Decimal("2.4")


def value(bits):
    return Decimal(struct.unpack("<f", struct.pack("<I", bits))[0])


def floor_bits(x):
    """The largest binary32 not above x (x >= 0), as bits: binary32 order is integer order."""
    low, high = 0, 0x7F7FFFFF
    while high - low > 0:
        middle = (low + high + 1) // 2
        if value(middle) <= x:
            low = middle
        else:
            high = middle - 1
    return low


def nearest(x):
    low = floor_bits(x)
    return low if x - value(low) <= value(low + 1) - x else low + 1


def at_least(x):
    low = floor_bits(x)
    return low if value(low) == x else low + 1


def rows(bits):
    texts = [float(value(b)).hex() + "f" for b in bits]
    return "".join("    " + ", ".join(texts[i:i + 4]) + ",\n" for i in range(0, 256, 4))


decode = [nearest(curve(Fraction(c, 255))) for c in range(256)]
threshold = [0] + [at_least(curve(Fraction(2 * c - 1, 510))) for c in range(1, 256)]
out = pathlib.Path(__file__).resolve().parent.parent / "hw/datapath/srgb_tables.inc"
out.write_text(
    "// Written by scripts/make_srgb_tables.py.\n"
    "const float decode_table[256] = {\n" + rows(decode) + "};\n"
    "// Entry 0 is not used: code 0 has no threshold.\n"
    "const float threshold_table[256] = {\n" + rows(threshold) + "};\n")
