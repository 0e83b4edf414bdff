#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <scalebreak/collisions/invariance/invariance_motion.hpp>
#include <scalebreak/collisions/invariance/invariance_trend.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// One collision of a scaled pair beside the original's at the same impact speed. Ratios are scaled over original. Where more
/// than the normal motion happens, all of it is that of the exact motion, at the input's own overlaps.
struct InvarianceRecord {
  std::string law;
  double factor = 1;
  double normal_speed = 0;  ///< [m/s]
  bool stuck = false;
  double restitution = 0;
  double restitution_original = 0;
  std::optional<double> sticking_speed;  ///< [m/s]
  std::optional<double> contact_time_ratio, max_overlap_ratio, sticking_speed_ratio;
  std::optional<double> contact_time_ratio_predicted;  ///< of laws that keep β and v̂: the ratio of the time scales
  std::optional<ComparedMotions> motions;              ///< where more than the normal motion happens
};

/// What a law keeps and moves, over all its factors and speeds. Of oblique and rolling impacts, the members here are those of the
/// normal motion by itself, the fixed-normal limit, and `motion` holds the rest; of wet ones they are the motion's.
struct LawSummary {
  std::string law;
  bool softer = false;                    ///< its factors here are below 1; "none" has a summary on either side
  double restitution_change = 0;          ///< largest |Δe| at equal speed; a pair that sticks has e = 0
  int verdict_changes = 0;                ///< speeds at which one of the two sticks and the other does not
  double reduced_restitution_change = 0;  ///< largest |Δe| at equal v/v_stick; 0 without adhesion
  bool exact = false;                     ///< the scaled pair has the original's v̂ and β at every speed
  Trend sticking_speed, contact_time, max_overlap;
  bool wet = false;                 ///< a liquid has its say in all of this
  std::vector<MotionTrend> motion;  ///< where more than the normal motion happens
};

struct InvarianceStudy {
  std::vector<double> speeds;
  std::optional<double> sticking_speed;  ///< of the original [m/s]
  std::vector<InvarianceRecord> records;
  std::vector<LawSummary> summaries;
  int skipped = 0;  ///< (law, factor) pairs that do not suit each other
  int deep = 0;     ///< collisions with more overlap than deep_overlap
  bool motion = false, wet = false;
};

/// Impact speeds about the sticking speed (0.5 to 100 times), or 0.001 to 10 m/s without adhesion.
[[nodiscard]] std::vector<double> default_speeds(std::optional<double> sticking_speed);

/// The laws of a study: those asked for, or all that suit the contact with at least one factor.
[[nodiscard]] std::vector<std::string> study_laws(const Input& input);

/// Compares every law at every factor with the original, exactly. The records come in the order law, factor, speed, the
/// same for any number of threads.
[[nodiscard]] InvarianceStudy run_invariance(const Input& input, int threads, const std::function<void(double)>& progress = {});

}  // namespace scalebreak
