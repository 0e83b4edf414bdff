#pragma once

#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <scalebreak/dem/dem.hpp>
#include <scalebreak/dem/height.hpp>
#include <scalebreak/dem/law_rows.hpp>
#include <scalebreak/dem/lists/grid.hpp>
#include <scalebreak/dem/lists/images.hpp>
#include <scalebreak/dem/lists/pairs.hpp>
#include <scalebreak/dem/lists/skins.hpp>
#include <scalebreak/dem/spheres.hpp>

namespace scalebreak {

/// What stands behind Dem. A step: spheres move, lists are made anew where that is due, forces. Every thread has a stretch of the sorted
/// spheres and the pairs whose first sphere is in it; forces on the spheres of others are put down and fetched by their owner.
class Dem::Engine {
 public:
  Engine(const System& start, const DemSetup& setup);
  Engine(std::string_view saved, const DemSetup& setup);

  void advance(long steps);

  [[nodiscard]] System system() const;
  [[nodiscard]] std::vector<ContactForce> contact_forces() const;
  [[nodiscard]] double elastic_energy() const;
  [[nodiscard]] std::string save() const;
  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] double time() const { return start_time_ + setup_.step * static_cast<double>(steps_); }

  long steps_ = 0;
  bool keep_sums_ = true;
  DemTotals totals_;
  dem::Spheres spheres_;
  const dem::Kernel& kernel_;

 private:
  /// A wall's near spheres, on one thread.
  struct WallPairs {
    dem::Pairs pairs;
    std::vector<dem::Contact> remembered;  ///< what comes into new lists
  };
  /// What one thread works on.
  struct Worker {
    std::uint32_t begin = 0, end = 0;            ///< of the sorted spheres
    LargeList<std::uint32_t> start, neighbours;  ///< of each of them
    dem::Pairs pairs;
    std::vector<dem::Contact> remembered;  ///< what comes into new lists
    std::vector<WallPairs> walls;
    LargeList<std::uint32_t> movers, pushed;  ///< of its own: who is near another, and who may bear a force
    std::vector<dem::Deferred> deferred;
    std::uint32_t deferred_count = 0;
    dem::LawRows rows, wall_rows;  ///< its own, where each contact has a row
    double fastest_squared = 0, resting_fastest_squared = 0;
    double normal_flux = 0;          ///< Σ m v_z², velocities of the forces' instant [J]
    std::vector<std::uint32_t> met;  ///< spheres of others that have begun a contact in this step
    dem::Tally tally;
    std::exception_ptr failure;
  };

  // engine_setup.cpp
  void set_up(const System& start);
  [[nodiscard]] std::vector<std::uint32_t> sort_out_kinds(const System& start);
  void make_rows();
  void make_workers();
  // engine_lists.cpp
  void make_grid(const std::vector<ContactMemory>& contacts);
  void wrap_spheres();
  void hand_out(const std::vector<ContactMemory>& contacts);
  void find_neighbours(Worker& worker);
  void select_pairs(Worker& worker);
  void select_wall(Worker& worker, std::size_t w);
  void take_contacts(Worker& worker, dem::Pairs& pairs, std::vector<dem::Contact>& remembered, bool wall);
  void reopen_rows(Worker& worker);
  void clear_marks(Worker& worker);
  void mark_movers(const Worker& worker);
  void collect_movers(Worker& worker);
  void collect_pushed(Worker& worker);
  /// Has a sphere on the list of those who may bear a force, if it is the worker's own. Was it not yet?
  bool push(Worker& worker, std::uint32_t sphere);
  /// The same of one that begins a contact, and has no force yet: what dashpots see of it is its velocity alone.
  void meet(Worker& worker, std::uint32_t sphere);
  /// A sphere that is near none, from the last lists to now: so many steps of velocity Verlet without a force.
  void fly(dem::Quad& position, dem::Quad& velocity) const;
  void bring_up_resting(Worker& worker);
  // engine_height.cpp
  void set_up_height(const System& start);
  /// Places and velocities of the worker's own spheres: from the height of the cell onto the next.
  void map_onto_height(Worker& worker);
  void stretch_cell();
  void sum_normal_flux(Worker& worker);
  /// The next height, by the stress of this step.
  void push_height();
  // engine_step.cpp
  void move(Worker& worker);
  void plan_lists();
  /// By how much histories go on before the forces and after them [s]. Beside velocities of the forces' instant they are kept half a step
  /// ahead of it, so that each step integrates them to second order.
  struct HistorySteps {
    double before, after;
  };
  [[nodiscard]] bool histories_are_ahead() const { return setup_.integrator == Integrator::synchronized; }
  [[nodiscard]] HistorySteps history_steps() const;
  /// The forces of the last step once more: histories come out as they went in.
  [[nodiscard]] HistorySteps history_steps_again() const;
  /// The same engine with histories of this instant, to be looked at and not to go on with.
  [[nodiscard]] Engine with_histories_of_now() const;
  void find_contacts(Worker& worker);
  void adopt_met(Worker& worker);
  void add_forces(Worker& worker, HistorySteps histories);
  void fetch_deferred(Worker& worker);
  void take_tallies();
  void finish_step();
  void kick(std::uint32_t sphere, double share);
  [[noreturn]] void unstable(double speed) const;
  template <class Work>
  void guarded(Worker& worker, Work work);
  void rethrow();

  [[nodiscard]] dem::ForceTask force_task(Worker& worker, dem::Pairs& pairs, const dem::WallView* wall, HistorySteps histories);
  class ListKeeper;
  [[nodiscard]] dem::LawRows& rows_for(Worker& worker, bool wall);
  [[nodiscard]] dem::LawRows::Kind kind_at(std::uint32_t sphere) const { return dem::kind_of(spheres_, material_, sphere); }
  [[nodiscard]] bool has_slides() const { return rows_.mapped().laws.tangential.acts(); }
  [[nodiscard]] bool has_rolls() const { return rows_.mapped().laws.rolling.acts() && !rows_.mapped().laws.rolling.rigid(); }
  [[nodiscard]] double largest_reach() const;
  [[nodiscard]] double travel_of(double fastest_squared) const;
  [[nodiscard]] Cell cell_now() const { return height_.follows() ? cell_ : advanced(cell_, setup_.step * static_cast<double>(steps_)); }
  [[nodiscard]] double image_offset() const;
  // engine_state.cpp
  [[nodiscard]] std::vector<ContactMemory> contact_memories() const;  ///< histories as they are kept
  [[nodiscard]] std::int32_t second_of(const dem::Contact& contact, const dem::WallView* wall) const;
  [[nodiscard]] double energy_of_springs() const;  ///< with histories as they are kept [J]
  template <class Archive>
  void archive_head(Archive& archive);
  template <class Archive>
  void archive_body(Archive& archive);

  DemSetup setup_;
  Cell cell_;  ///< at the start; with a height that follows, at the last step
  double start_time_ = 0;
  bool turns_ = false;
  bool each_ = false;  ///< has each contact laws of its own?
  std::vector<dem::LawRows::Kind> kinds_;
  std::vector<std::uint8_t> material_;  ///< in the order of identity
  dem::LawRows rows_, wall_rows_;
  std::vector<dem::WallView> walls_;
  double smallest_ = 0, largest_ = 0, volume_fraction_ = 0;  ///< radii [m]
  double flow_rate_ = 0;                                     ///< of the profile that speeds are bounded about [1/s]

  std::vector<Worker> workers_;
  LargeList<std::uint8_t> moves_;   ///< of each sphere: is it near another?
  LargeList<std::uint8_t> pushed_;  ///< is it on the list of those who may bear a force?
  std::optional<dem::Grid> grid_;
  dem::Images images_;
  double grid_offset_ = 0;  ///< of the image above when the grid was made; with a height that follows, at the last step [m]
  dem::Height height_;
  double stretch_ = 1;       ///< by which the height changes in the next step
  double stretch_rate_ = 0;  ///< of the height, as the forces of the last step saw it [1/s]
  dem::Skins skins_;
  double fastest_squared_ = 0;
  double travel_ = 0, travel_of_grid_ = 0;  ///< by which a gap can have closed since the last lists [m]
  long steps_at_grid_ = 0, steps_since_lists_ = 0;
  bool lists_due_ = false, grid_due_ = false, failed_ = false;
};

}  // namespace scalebreak
