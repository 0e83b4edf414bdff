#pragma once

#include <string>
#include <vector>

#include <scalebreak/collisions/invariance/invariance.hpp>

namespace scalebreak {

/// What a law keeps and moves of the normal motion, in one sentence, and of the whole motion, in another.
[[nodiscard]] std::string in_words(const LawSummary& summary);

/// The law, and on which side of 1 its factors are where it takes both.
[[nodiscard]] std::string full_name(const LawSummary& summary);

/// The same in a table's cell: "kept", "factor^-0.400", "moves by up to 0.3".
[[nodiscard]] std::string verdict(const Trend& trend);
[[nodiscard]] std::string verdict(const MotionTrend& trend);

}  // namespace scalebreak
