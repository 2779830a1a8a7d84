#!/usr/bin/env python3
"""check_names FILE...: every type that two files define under one name, a line each; exit code 1 if there is one.

Two types of one name in one namespace are undefined behaviour that no compiler sees: of what both have, a destructor or
a vector's growth, the linker takes whichever comes first.  Types of unnamed namespaces are each file's own."""
import collections
import re
import sys

NAMESPACE = re.compile(r"\s*(?:inline\s+)?namespace\s*([\w:]*)\s*\{")
TYPE = re.compile(r"\s*(?:template\s*<.*>\s*)?(?:struct|class|enum class|enum|union)\s+(?:alignas\s*\([^)]*\)\s*)?(\w+)\s*(?:final\s*)?(?::[^:].*)?\{")


def code_of(path):
    """The text without comments, raw strings, strings and characters, whose braces are none."""
    text = open(path, encoding="utf-8").read()
    pattern = r'R"(\w*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\''
    return re.sub(pattern, lambda m: "" if m[0].startswith("/") else '""', text, flags=re.DOTALL)


def types_of(path):
    """Full names of the types that a file defines in named namespaces."""
    inside = []  # what is open: the name of a namespace, "" for an unnamed one, None for anything else
    for line in code_of(path).splitlines():
        space = NAMESPACE.match(line)
        if space:
            inside.append(space[1])
            line = line[space.end():]
        elif all(inside):
            found = TYPE.match(line)
            if found:
                yield "::".join([*inside, found[1]])
        for brace in re.findall(r"[{}]", line):
            if brace == "{":
                inside.append(None)
            elif inside:
                inside.pop()


if sys.argv[1:2] in (["-h"], ["--help"]):
    sys.exit(print(__doc__))
files = collections.defaultdict(list)
for path in sys.argv[1:]:
    for name in types_of(path):
        files[name].append(path)
twice = {name: paths for name, paths in files.items() if len(paths) > 1}
for name, paths in sorted(twice.items()):
    print(f"{name} is defined in {' and in '.join(paths)}; one of them must be called otherwise")
sys.exit(1 if twice else 0)
