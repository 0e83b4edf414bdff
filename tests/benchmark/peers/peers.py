#!/usr/bin/env python3
"""Speed beside other engines: runs every engine of a scene in turn, again and again, and writes speed.csv and speed.md.

Called by run_peers.sh, which builds this project's programs and makes the states; see README.md.
"""
import argparse, csv, math, os, re, statistics, subprocess, sys

HERE = os.path.dirname(os.path.abspath(__file__))
DECKS = os.path.join(HERE, "decks")

# Of a scene: Young's modulus [Pa], start state, warm-up and timed steps (as peer_scene.cpp), neighbour skins [m] that proved fastest.
SCENES = {
    "S1": dict(young="1e8", state="gas", warm=500, timed=1000, skin=dict(lammps="1e-4", liggghts="5e-5", yade="5e-5")),
    "S2": dict(young="1e8", state="gas", warm=500, timed=1000, skin=dict(lammps="1e-4", liggghts="5e-5")),
    "S3": dict(young="1e8", state="thin", warm=500, timed=1000, skin=dict(lammps="2e-4", liggghts="2e-4", yade="1e-4")),
    "S4": dict(young="1e7", state="bed", warm=500, timed=500, skin=dict(lammps="2e-5", liggghts="5e-5", yade="5e-5")),
    "S5": dict(young="1e7", state="bed", warm=500, timed=500, skin=dict(lammps="2e-5", liggghts="5e-5")),
}
ADHESIVE, BEDS = {"S2", "S5"}, {"S4", "S5"}
SKINS = ["2e-5", "5e-5", "1e-4", "2e-4", "4e-4"]
ROOT = ["--allow-run-as-root"] if os.getuid() == 0 else []


def same_physics(engine, scene):
    """The law and the boundaries of the scene, up to what README.md lists."""
    if engine == "liggghts": return scene not in ADHESIVE
    if engine == "yade": return scene not in BEDS
    return engine != "scalebreak full"


def engines_of(scene, chosen):
    names = ["scalebreak"] + (["scalebreak full"] if scene in ADHESIVE else []) + ["lammps", "liggghts"]
    return [n for n in names + (["yade"] if scene not in ADHESIVE else []) if n.split()[0] in chosen]


def rayleigh_step(young):
    """0.15 of the Rayleigh step of a sphere of 1 mm, 2500 kg/m3, Poisson's ratio 0.25 (Washino et al. 2024, eq. 55) [s]."""
    return 0.15 * math.pi * 5e-4 * math.sqrt(2 * 2500 * 1.25 / float(young)) / (0.8766 + 0.163 * 0.25)


def command(engine, scene, cores, o):
    s = SCENES[scene]
    state, skin = os.path.join(o.work, s["state"] + ".data"), s["skin"].get(engine)
    pinned = ["taskset", "-c", ",".join(o.cores.split(",")[:cores])]
    if engine.startswith("scalebreak"):
        extra = (["--full"] if "full" in engine else []) + (["--kernel", o.kernel] if o.kernel else [])
        return pinned + [os.path.join(o.bin, "scalebreak_peer_scene"), scene, state, "--threads", str(cores)] + extra
    if engine == "yade":
        return pinned + ["yade", "-x", "-n", "-j%d" % cores, os.path.join(DECKS, "yade_scene.py"), state, scene, str(s["warm"]),
                         str(s["timed"] // 5), skin, "%.8g" % rayleigh_step(s["young"])]
    launch = pinned if cores == 1 else pinned + ["mpirun", *ROOT, "--oversubscribe", "--bind-to", "none", "-np", str(cores)]
    given = dict(E=s["young"], skin=skin, warm=s["warm"], n=s["timed"])
    if scene in BEDS: given.update(bed=1, upper="f")
    if engine == "lammps":
        given.update(state=state, decks=DECKS, model="jkr" if scene in ADHESIVE else "hertz")
        words = ["lmp", "-log", "none", "-in", os.path.join(DECKS, "lammps_scene.in")]
    else:
        given.update(state=state.replace(".data", ".liggghts.data"), dt="%.8g" % rayleigh_step(s["young"]))
        if scene in ADHESIVE: given.update(cohesion="sjkr", rolling="epsd2")
        words = ["liggghts", "-log", "none", "-in", os.path.join(DECKS, "liggghts_scene.in")]
    return launch + words + [w for k, v in given.items() for w in ("-var", k, str(v))]


def run(engine, scene, cores, o):
    """Particle-steps per second, contacts per sphere before and after the timed steps, bytes per sphere (or None)."""
    words = command(engine, scene, cores, o)
    done = subprocess.run(words, cwd=o.work, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env=dict(os.environ, OMP_NUM_THREADS=str(cores if engine.startswith(("scalebreak", "yade")) else 1)))
    text = done.stdout
    said = dict(re.findall(r"(\w+)=(\S+)", text))
    if "particle_steps_per_second" in said:
        return (float(said["particle_steps_per_second"]), float(said["contacts_before"]), float(said["contacts_after"]),
                float(said["bytes_per_sphere"]) if "bytes_per_sphere" in said else None)
    loops = re.findall(r"Loop time of (\S+) on \d+ procs for (\d+) steps with (\d+) atoms", text)
    rows = re.findall(r"^\s*\d+(?:\s+[-+.\de]+){2}\s+([-+.\de]+)\s*\nLoop time", text, re.M)
    if done.returncode or len(loops) != 2 or len(rows) != 2:
        sys.exit("%s failed on %s: %s\n%s" % (engine, scene, " ".join(words), text[-1500:]))
    seconds, steps, atoms = float(loops[1][0]), int(loops[1][1]), int(loops[1][2])
    memory = re.findall(r"memory allocation.*= \S+ \| (\S+) \||Memory usage per processor = (\S+)", text)
    mib = float(next(filter(None, memory[-1]))) * cores
    return atoms * steps / seconds, float(rows[0]), float(rows[1]), mib * 2**20 / atoms


def tune(o, engines):
    for scene in o.scenes:
        for engine in ("lammps", "liggghts"):
            if engine not in engines: continue
            speeds = {}
            for skin in SKINS:
                SCENES[scene]["skin"][engine] = skin
                speeds[skin] = run(engine, scene, 1, o)[0]
            SCENES[scene]["skin"][engine] = max(speeds, key=speeds.get)
            print("%s %s: " % (scene, engine) + ", ".join("skin %s m %.3g/s" % i for i in speeds.items()), flush=True)


def contacts_differ(ours, theirs, spheres):
    """A sentence where contacts per sphere differ by more than 4 standard errors of counting them, or 1 %, whichever is more."""
    for when, a, b in (("before", ours[0], theirs[0]), ("after", ours[1], theirs[1])):
        allowed = max(4 * math.sqrt(2 * (a + b) / spheres), 0.01 * a)
        if abs(a - b) > allowed: return "%s the timed steps %.4f, scalebreak %.4f, allowed difference %.4f" % (when, b, a, allowed)


def main():
    a = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    a.add_argument("--work", required=True, help="folder of the states, and of what is written")
    a.add_argument("--bin", required=True, help="folder of this project's programs")
    a.add_argument("--scenes", default="S1,S2,S3,S4,S5", type=lambda t: t.split(","))
    a.add_argument("--engines", default="scalebreak,lammps,liggghts,yade", type=lambda t: t.split(","))
    a.add_argument("--repeats", type=int, default=3)
    a.add_argument("--cores", default="1,0", help="one core is the first of these, two are both")
    a.add_argument("--kernel", default="", help="instruction set of this project: baseline, avx2 or avx512")
    a.add_argument("--tune", action="store_true", help="first find the fastest neighbour skin of LAMMPS and of LIGGGHTS, here")
    a.add_argument("--quick", action="store_true", help="one repeat, one core, without Yade")
    o = a.parse_args()
    if o.quick: o.repeats, o.engines = 1, [e for e in o.engines if e != "yade"]
    if o.tune: tune(o, o.engines)
    spheres = sum(1 for line in open(os.path.join(o.work, "gas.data")) if len(line.split()) == 7) // 2
    rows, table, complaints = [], [], []
    for scene in o.scenes:
        engines, speed, contacts, memory = engines_of(scene, o.engines), {}, {}, {}
        for repeat in range(o.repeats):
            for cores in (1,) if o.quick else (1, 2):
                for engine in engines:
                    if engine == "yade" and repeat > 0: continue
                    psteps, before, after, size = run(engine, scene, cores, o)
                    speed.setdefault((engine, cores), []).append(psteps)
                    contacts[engine] = (before, after)
                    if cores == 1: memory[engine] = size
                    rows.append([scene, engine, cores, repeat + 1, "%.5g" % psteps, before, after, "" if size is None else "%.0f" % size])
                    print("%s %-15s cores %d  %.4g particle-steps/s, contacts %.4f, %.4f" % (scene, engine, cores, psteps, before, after), flush=True)
        median = {k: statistics.median(v) for k, v in speed.items()}
        for engine in engines:
            if engine != "scalebreak" and "scalebreak" in engines and same_physics(engine, scene):
                found = contacts_differ(contacts["scalebreak"], contacts[engine], spheres)
                if found: complaints.append("%s: contacts per sphere of %s %s" % (scene, engine, found))
            cells = [scene, engine + ("" if same_physics(engine, scene) else " (other physics)")]
            for cores in (1, 2):
                peers = [median[k] for k in median if k[1] == cores and not k[0].startswith("scalebreak") and same_physics(k[0], scene)]
                mine = median.get((engine, cores))
                cells.append("" if mine is None else "%.3g [%.3g, %.3g]" % (mine, min(speed[engine, cores]), max(speed[engine, cores])))
                cells.append("%.2f" % (mine / max(peers)) if mine and peers else "")
            table.append(cells + ["%.4f" % contacts[engine][0], "%.4f" % contacts[engine][1], "" if memory[engine] is None else "%.0f" % memory[engine]])
    with open(os.path.join(o.work, "speed.csv"), "w", newline="") as f:
        w = csv.writer(f)
        w.writerow(["scene", "engine", "cores", "run", "speed [particle-steps/s]", "contacts_before [-]", "contacts_after [-]", "memory [B/sphere]"])
        w.writerows(rows)
    head = ["scene", "engine", "one core [particle-steps/s]", "over best peer", "two cores", "over best peer", "contacts before", "after", "bytes per sphere"]
    lines = ["| " + " | ".join(r) + " |" for r in [head, ["---"] * len(head)] + table]
    notes = ["", "%d spheres; median [least, most] of %d runs in turn; skins [m]: " % (spheres, o.repeats) +
             "; ".join("%s " % s + ", ".join("%s %s" % i for i in SCENES[s]["skin"].items()) for s in o.scenes) + "."]
    with open(os.path.join(o.work, "speed.md"), "w") as f: f.write("\n".join(lines + notes) + "\n")
    print("\n".join(lines + notes))
    for c in complaints: print("NOT THE SAME PHYSICS: " + c, file=sys.stderr)
    sys.exit(1 if complaints else 0)


main()
