"""Does an object compiled for a wider instruction set share a weak function with any other?

The linker keeps one definition of a weak function and drops the rest. Were it the one compiled for AVX-512, the program would crash on a
processor without, wherever that function is called from. So what kernel_avx2.cpp and kernel_avx512.cpp define must be theirs alone.

usage: kernel_symbols.py NM WIDE[,WIDE...] FILE...     names of the wide objects; objects and archives to look through
"""
import re
import subprocess
import sys


def weak_and_defined(nm, files):
    """Of each object, by the name nm gives it: its weak functions, and all symbols that it defines."""
    weak, defined = {}, {}
    listing = subprocess.run([nm, "-A", "--defined-only", *files], check=True, capture_output=True, text=True).stdout
    for line in listing.splitlines():
        match = re.match(r"^(.*?):?([0-9a-f]{8,16}) (\w) (\S+)$", line)
        if not match:
            continue
        origin, _, kind, name = match.groups()
        defined.setdefault(origin, set()).add(name)
        if kind in "Wi":  # V and u are data
            weak.setdefault(origin, set()).add(name)
    return weak, defined


def main():
    nm, wide, files = sys.argv[1], sys.argv[2].split(","), sys.argv[3:]
    weak, defined = weak_and_defined(nm, files)
    found, shared = set(), []
    for origin, symbols in defined.items():
        names = [name for name in wide if origin.endswith(name)]
        if not names:
            continue
        found.update(names)
        for other, others in defined.items():
            if other != origin:
                shared += [(symbol, origin, other) for symbol in sorted(weak.get(origin, set()) & others)]
    missing = set(wide) - found
    if missing:
        sys.exit(f"no object is called {', '.join(sorted(missing))}: nothing was looked at")
    for symbol, origin, other in shared:
        print(f"{symbol} is weak in {origin} and also in {other}")
    print(f"{len(found)} wide objects, {len(defined)} objects, {len(shared)} shared weak functions")
    sys.exit(1 if shared else 0)


main()
