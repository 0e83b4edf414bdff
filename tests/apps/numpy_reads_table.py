"""NumPy reads what docs/tables.md says it does. Arguments: the program, an empty folder."""

import json
import math
import pathlib
import subprocess
import sys

import numpy

program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
subprocess.run([program, "table", "--tables", str(folder), "--quiet", "--json"], check=True, stdout=subprocess.DEVNULL)
table = numpy.load(folder / "jkr-full-contact_radius-1e-06.npy")
about = json.loads((folder / "jkr-full-contact_radius-1e-06.json").read_text())

assert table.dtype.names == ("damping_ratio", "speed", "sticking_speed", "restitution", "contact_time", "max_overlap")
assert table.shape == (about["damping_axis"]["count"], about["speed_axis"]["count"])
assert about["quality"]["error_max"] < about["key"]["tolerance"] == 1e-6
# The undamped row in closed form: e² = 1 − (v_s/v)².
row = table[0]
assert numpy.all(row["damping_ratio"] == 0)
assert numpy.allclose(row["restitution"] ** 2, 1 - (row["sticking_speed"] / row["speed"]) ** 2, atol=1e-9)
assert math.isclose(row["sticking_speed"][0], math.sqrt(2 * 0.9355028 / 48 ** (1 / 3)), rel_tol=1e-7)
print("OK")
