# What each row of data/reference/compensation.csv is off its original by, in per cent, with the standard error; the coordination is first multiplied by
# factor^(2/5), as contact times grow by factor^(-2/5).
#   awk -F, -f deviations.awk ../../../data/reference/compensation.csv > deviations.csv
function name(column) { sub(/ \[.*/, "", column); return column }
NR == 1 {
  line = "variant,volume_fraction [-],factor [-],surface_energy [J/m2]"
  for (i = 12; i <= 22; i += 2) line = line "," name($i) " [%]," name($i) "_error [%]"
  print line
}
NR > 1 { rows[NR] = $0; if ($1 == "original") original[$2, $4] = $0 }
END {
  for (r = 2; r <= NR; ++r) {
    split(rows[r], row, ",")
    if (split(original[row[2], row[4]], other, ",") == 0 || row[1] == "original") continue
    line = row[1] "," row[2] "," row[3] "," row[4]
    for (i = 12; i <= 22; i += 2) {
      ratio = row[i] / other[i] * (i == 22 ? row[3] ^ 0.4 : 1)
      error = row[i + 1] == "" || other[i + 1] == "" ? "" : sprintf("%.2f", 100 * ratio * sqrt((row[i + 1] / row[i]) ^ 2 + (other[i + 1] / other[i]) ^ 2))
      line = line sprintf(",%.2f,%s", 100 * (ratio - 1), error)
    }
    print line
  }
}
