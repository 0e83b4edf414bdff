# Yade: one scene of the speed comparison, a periodic gas (S1, S3) or a bed (S4), from a LAMMPS data file.
#     yade -x -n -j THREADS yade_scene.py STATE.data SCENE WARM TIMED VERLET_DISTANCE STEP
# A box as a floor does not touch spheres in its periodic cell: instead, the bottom layer of the bed is held. Prints one line.
import math, os, sys, time
from yade import *
state, scene, warm, timed, verlet, step = sys.argv[1:7]
warm, timed = int(warm), int(timed)
bed = scene == "S4"
size, spheres, velocity, section = [0.0] * 3, {}, {}, ""
for line in open(state):
    w = line.split("#")[0].split()
    if len(w) == 4 and w[2][1:] == "lo": size["xyz".index(w[2][0])] = float(w[1]) - float(w[0])
    elif len(w) == 1: section = w[0]
    elif section == "Atoms" and len(w) >= 7: spheres[int(w[0])] = [float(q) for q in w[2:7]]
    elif section == "Velocities" and len(w) == 7: velocity[int(w[0])] = [float(q) for q in w[1:4]]
diameter, density = next(iter(spheres.values()))[:2]
young = 1e7 if bed else 1e8  # [Pa]
material = O.materials.append(FrictMat(young=young, poisson=0.25, density=density, frictionAngle=math.atan(0.3)))
lift = 2 * diameter if bed else 0
O.periodic = True
O.cell.hSize = Matrix3(size[0], 0, 0, 0, size[1], 0, 0, 0, size[2] * (2 if bed else 1))
for i in sorted(spheres):
    x = spheres[i][2:]
    b = sphere((x[0], x[1], x[2] + lift), diameter / 2, material=material)
    b.state.vel = Vector3(*velocity[i])
    if bed and x[2] < 0.75 * diameter:
        b.state.blockedDOFs = "xyzXYZ"
        b.state.vel = Vector3(0, 0, 0)
    O.bodies.append(b)
value = lambda v: MatchMaker(algo="val", val=v)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=float(verlet), allowBiggerThanPeriod=True),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(en=value(0.81), es=value(0.81))],
                    [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(damping=0, gravity=(0, 0, -9.81 if bed else 0)),
]
O.dt = float(step)
contacts = lambda: 2.0 * O.interactions.countReal() / len(spheres)
O.run(warm, True)
before, start = contacts(), time.time()
O.run(timed, True)
seconds = time.time() - start
print("particle_steps_per_second=%.5g contacts_before=%.4f contacts_after=%.4f" % (len(spheres) * timed / seconds, before, contacts()))
sys.stdout.flush()
os._exit(0)
