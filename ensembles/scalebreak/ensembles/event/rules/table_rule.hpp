#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <scalebreak/collisions/tables/size_tables.hpp>
#include <scalebreak/ensembles/event/rules/collision_rule.hpp>
#include <scalebreak/scene/input.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// Spheres that are all alike.
struct SphereKind {
  double radius = 0;  ///< of the scaled system [m]
  std::uint8_t material = 0;
  bool operator==(const SphereKind&) const = default;
};

/// The spheres of a flow: all kinds that there are, or, where these are many, the smallest and the largest of each material.
struct SphereKinds {
  std::vector<SphereKind> kinds;
  bool many = false;
};

/// Throws InputError for laws that no collision table describes: scaling laws that map forces, liquids.
void refuse_laws_without_tables(const Input& input);

/// Why no collision table serves a flow's spheres by its laws, in words; empty where one does.
[[nodiscard]] std::string why_no_tables(const Input& input);

/// Throws InputError where the height of the cell follows a pressure: its stress is known at every step of soft spheres alone.
void refuse_height_that_follows(const Input& input);

/// What is done with a collision that no table answers: the exact engine resolves it, or it is left to who asks.
enum class Unanswered { integrate, leave };

/// Collisions of soft spheres by the tables of an input's laws, under its scaling law: each as if no third sphere were near, with its
/// effective distance, so that both spheres fly on where an isolated soft collision would have left them. Where a table does not answer
/// (the contact turns too far, or is beyond it) the exact engine does, and it is counted.
class TableRule {
 public:
  static constexpr bool spins = true, displaces = true, lasts = true;
  /// Up to so many radii and materials each pair of them has its own tables in memory; of more, all sizes share theirs (SizeTables).
  static constexpr std::size_t most_kinds = 8;

  /// Obtains the tables of all pairs of spheres that a flow has. Throws InputError where no table can serve: laws that act at a distance or
  /// map forces; these are never answered where what is not is left.
  TableRule(const Input& input, SphereKinds kinds, const TableStore& store, const PairTolerance& tolerance = {},
            Unanswered unanswered = Unanswered::integrate);

  /// Throws WorkError where the two stick and nothing is left.
  [[nodiscard]] Parting collide(const Meeting& meeting);
  /// The same as it was answered, and is no longer counted.
  [[nodiscard]] Parting take_back(const Meeting& meeting);

  /// Collisions that were integrated for a reason; for Refusal::none, looked up.
  [[nodiscard]] long count(Refusal reason) const { return counts_[static_cast<std::size_t>(reason)]; }
  [[nodiscard]] long integrated() const;
  /// Of two that glance off each other so slowly that, along their new paths, they would have been nearest while still in contact: they are
  /// put behind by as much, so that they do not seem to meet again.
  [[nodiscard]] long delayed() const { return delayed_; }

  [[nodiscard]] const SphereKinds& kinds() const { return kinds_; }
  /// All that is counted.
  void save(std::string& bytes) const;
  void load(std::string_view& bytes);

 private:
  /// What answers a meeting: the tables of its pair, or those that its sizes share; neither where no table can serve.
  struct Answerer {
    const PairResolver* own = nullptr;
    const SizeTables* shared = nullptr;
  };
  [[nodiscard]] std::size_t kind_of(const Meeting::Body& body) const;
  [[nodiscard]] Answerer answerer(const Meeting& meeting) const;
  [[nodiscard]] Parting answer(const Meeting& meeting, int count);
  void obtain_shared(const Input& input, const TableStore& store, const PairTolerance& tolerance, bool walled);

  SphereKinds kinds_;
  std::vector<std::unique_ptr<PairResolver>> pairs_;  ///< first · kinds + second; null where no table can serve
  std::vector<std::unique_ptr<PairResolver>> walls_;
  std::array<std::unique_ptr<SizeTables>, 4> shared_;  ///< 2 · material of the first + that of the second
  std::array<std::unique_ptr<SizeTables>, 2> shared_walls_;
  Unanswered unanswered_;
  bool wall_no_slip_ = false;
  long delayed_ = 0;
  std::array<long, static_cast<std::size_t>(Refusal::count)> counts_{};
};

/// The kinds of spheres of a flow, in the order in which they are first met; of more than `most_kinds` the extremes.
[[nodiscard]] SphereKinds kinds_of(const System& system);

}  // namespace scalebreak
