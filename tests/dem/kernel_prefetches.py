"""Do the hot loops ask for what they will need before long? A compiler may leave such requests out, and no result tells.

usage: kernel_prefetches.py OBJDUMP LOOP[,LOOP...] FILE     names of the loops, in each of the instruction sets' namespaces; the archive they are in
"""
import re
import subprocess
import sys

SETS = ["baseline", "avx2", "avx512"]


def functions_that_ask(objdump, file):
    """Of each function of the archive: does it ask?"""
    listing = subprocess.run([objdump, "-d", "-C", "--no-show-raw-insn", file], check=True, capture_output=True, text=True).stdout
    asks, name = {}, ""
    for line in listing.splitlines():
        match = re.match(r"^[0-9a-f]+ <(.*)>:$", line)
        if match:
            name = match[1]
            asks.setdefault(name, False)
        elif "\tprefetch" in line:
            asks[name] = True
    return asks


def main():
    objdump, loops, file = sys.argv[1], sys.argv[2].split(","), sys.argv[3]
    asks = functions_that_ask(objdump, file)
    silent = [(each, loop) for each in SETS for loop in loops if not any(f"::{each}::" in name and f"::{loop}" in name for name in asks if asks[name])]
    for each, loop in silent:
        print(f"{loop} of {each} asks for nothing")
    sys.exit(1 if silent else 0)


main()
