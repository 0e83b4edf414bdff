#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scalebreak/collisions/invariance/invariance.hpp>

namespace scalebreak {

/// What the exact motion adds to a record in files: nothing where there is no motion, or it sticks.
struct MotionMember {
  const char* key;
  const char* unit;
  std::optional<double> (*of)(const InvarianceRecord&);
};
[[nodiscard]] const std::vector<MotionMember>& motion_members();

/// invariance.csv: one row a record.
[[nodiscard]] std::string records_csv(const InvarianceStudy& study);
/// summary.csv: one row a law, its normal motion.
[[nodiscard]] std::string summary_csv(const InvarianceStudy& study);
/// motion.csv: one row a law and quantity of the exact motion.
[[nodiscard]] std::string motion_csv(const InvarianceStudy& study);

}  // namespace scalebreak
