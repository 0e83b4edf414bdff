# Prints the command of every row of data/reference/compensation.csv; what it writes goes to out/compensation/<row>.
#   awk -F, -f docs/measured/compensation/runs.awk data/reference/compensation.csv | sh
NR > 1 {
  printf "scalebreak run data/studies/compensation.toml --engine dem --threads 1 --quiet"
  printf " --set particles.radius=%s --set particles.volume_fraction=0 --set 'cell.size=[%s,%s,%s]'", $5, $9, $9, $9
  printf " --set material.density=%s --set material.restitution=%s --set material.sliding_friction=%s", $6, $7, $8
  printf " --set run.replicas=%s --set run.strain=%s --set scaling.law=%s --set scaling.factor=%s", $10, $11, $3 == 1 ? "none" : "rps", $3
  if ($4 > 0)
    printf " --set material.surface_energy=%s --set contact.normal=jkr --set contact.adhesion_range=full" \
           " --set contact.damping_on=contact_radius --set contact.tangential_radius=contact_radius", $4
  printf " --out out/compensation/%s_%s_%s_%s\n", $1, $2, $3, $4
}
