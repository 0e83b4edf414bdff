#pragma once

#include <filesystem>
#include <string>

#include <scalebreak/collisions/invariance/invariance.hpp>
#include <scalebreak/output/html.hpp>

namespace scalebreak {

/// Which motion a chapter is about, and how its verdicts are to be read.
[[nodiscard]] std::string motion_introduction(const Input& input);

/// The table of laws and quantities of the exact motion.
void report_motion(const InvarianceStudy& study, HtmlReport& report);

/// The charts of an oblique, rolling or wet input, of those quantities that its motion has: the spin gained against the factor
/// (spin_ratio.csv and spin_ratio_stiffness.csv), the tangential restitution against the impact angle (angle.csv), and the angular momentum that the pair gains
/// against the size ratio (angular_momentum.csv). Draws nothing of a head-on dry one. False if a plot could not be drawn.
bool write_oblique_charts(const Input& input, const InvarianceStudy& study, const std::string& title, const std::filesystem::path& folder,
                          int threads, HtmlReport& report);

}  // namespace scalebreak
