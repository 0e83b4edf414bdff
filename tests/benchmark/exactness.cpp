#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/collisions/normal/normal_collision.hpp>
#include <scalebreak/contact/damping.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/output/plot.hpp>

#include "collisions/kinds.hpp"

// Error of the exact engine against its tolerance, from a reference in long double: exactness.csv and a plot, into the
// folder that is named.

int main(int argc, char** argv) {
  using namespace scalebreak;
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const double beta = damping_ratio(0.81);
  Csv csv({"contact", "tolerance [-]", "restitution_error [-]", "contact_time_error [-]", "steps"});
  Plot plot{"exactness",
            "Error of an exact collision against its tolerance (e = 0.81, v = 3 reduced units)",
            "tolerance asked for [-]",
            "larger error of restitution and relative contact time [-]",
            true,
            true,
            {}};
  int style = 1;
  for (const ContactKind& kind : all_contact_kinds()) {
    const double speed = kind.adhesive() ? 3.0 : 1.0;
    const auto reference = resolve_normal_collision<long double>(kind, beta, speed, {.tolerance = 1e-17L});
    for (int i = 24; i <= 52; ++i) {
      const double tolerance = std::pow(10.0, -i / 4.0);
      const auto outcome = resolve_normal_collision<double>(kind, beta, speed, {.tolerance = tolerance});
      csv.add({tests::kind_name(kind), tolerance, std::abs(static_cast<double>(outcome.restitution - reference.restitution)),
               std::abs(static_cast<double>(outcome.contact_time / reference.contact_time - 1)), static_cast<double>(outcome.steps)});
    }
    plot.curves.push_back({"exactness.csv", "2", "($3 > $4 ? $3 : $4)", to_string(kind), true, style++,
                           fmt::format("strcol(1) eq '{}'", tests::kind_name(kind))});
  }
  plot.curves.push_back({"exactness.csv", "2", "2", "error = tolerance", false, 0});
  write_file(folder / "exactness.csv", csv.text());
  return draw(plot, folder) ? 0 : 1;
}
