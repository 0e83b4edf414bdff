#include <cstdlib>

#include <fmt/format.h>

#include <scalebreak/collisions/tables/table_store.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/csv.hpp>

#include "ensembles/clusters.hpp"

// Rows and random clusters of 3 to 20 spheres by the hybrid and by collisions of two at a time, beside the exact engine:
//
//     scalebreak_patch_errors FILE.csv [SEEDS]
//
// docs/measured/patches has what 200 seeds gave, and the script that draws it.

int main(int count, char** words) {
  using namespace scalebreak;
  using namespace scalebreak::tests;
  if (count < 2) {
    fmt::print(stderr, "scalebreak_patch_errors FILE.csv [SEEDS]\n");
    return 2;
  }
  const auto seeds = static_cast<unsigned>(count > 2 ? std::strtoul(words[2], nullptr, 10) : 200);
  const Input input = flow_of("normal = \"hertz\"\ntangential = \"mindlin\"", 1e8);
  const TableStore store{.folder = default_table_folder()};
  Csv csv({"scene", "spheres [-]", "seed", "hybrid_step_0.15 [-]", "hybrid_step_0.02 [-]", "event [-]"});
  for (unsigned seed = 0; seed < seeds; ++seed) {
    const int spheres = spheres_of(seed);
    const auto add = [&](const char* scene, const FewSpheres& few) {
      const EngineErrors errors = errors_of(few, input, store);
      csv.add(
          {std::string(scene), static_cast<double>(spheres), static_cast<double>(seed), errors.hybrid, errors.hybrid_fine, errors.event});
    };
    add("cluster", cluster(seed, spheres));
    add("row", random_row(seed, spheres));
    write_file(words[1], csv.text());
  }
  return 0;
}
