#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <scalebreak/ensembles/event/event_totals.hpp>
#include <scalebreak/ensembles/event/flight/flight.hpp>
#include <scalebreak/ensembles/event/queue/calendar_queue.hpp>
#include <scalebreak/ensembles/event/rules/collision_rule.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

struct EventSetup {
  Eigen::Vector3d gravity{0, 0, 0};  ///< acceleration [m/s²]
  double allowance = 0;              ///< how far a sphere goes before its list is made anew [m]; 0: what is fast at this volume fraction
};

/// Spheres that fly freely between collisions that take no time: the event-driven engine, with one future event a sphere. What a
/// sphere foresees is what it meets first among its neighbours as they fly now; whoever's path changes looks anew at all of its
/// neighbours, so that of each pair at least one has in its event a time not after that of their meeting.
///
/// Bits: the same whatever the queue, and however often the flow is looked at on its way; also across save().
template <class Queue, class Rule>
class EventSpheres {
 public:
  /// Throws InputError where the spheres and the cell do not go together: a periodic edge too short, too many spheres.
  EventSpheres(const System& start, const EventSetup& setup, Rule rule);
  /// Goes on where another left off; setup and rule must be those that it had.
  EventSpheres(std::string_view saved, const EventSetup& setup, Rule rule);

  /// To a time [s]. Throws WorkError where so many collisions crowd into no time that it would never be reached.
  void advance_to(double time);
  /// So many collisions on, to the time of the last.
  void advance_collisions(long collisions);

  [[nodiscard]] double time() const { return base_ + now_; }
  [[nodiscard]] std::size_t count() const { return flight_.sphere.size(); }
  [[nodiscard]] const EventTotals& totals() const { return totals_; }
  [[nodiscard]] std::uint64_t queue_operations() const { return queue_operations_ + queue_.operations(); }
  /// The state at this time, in the order of identity.
  [[nodiscard]] System system() const;
  [[nodiscard]] double mean_neighbours() const;
  [[nodiscard]] Rule& rule() { return rule_; }
  [[nodiscard]] const Rule& rule() const { return rule_; }

  /// Everything, bit for bit.
  [[nodiscard]] std::string save() const;

 private:
  struct Body {
    double mass = 0;
    std::uint32_t identity = 0;
    std::uint8_t material = 0;
  };

  void look_ahead(std::uint32_t i);
  void happen(std::uint32_t i);
  void collide(std::uint32_t i, Neighbour partner);
  void collide_with_wall(std::uint32_t i, std::uint32_t wall);
  void end_list(std::uint32_t i);
  /// Brings all to now, which becomes time 0, puts those that are near in space near in memory, and makes lists and events.
  void renew();
  void reorder();
  void watch_for_collapse();
  /// Everything that is saved and is not a list, the same for both ways.
  template <class Numbers>
  void go_through_numbers(Numbers&& number);
  [[nodiscard]] Meeting::Body meeting_body(std::uint32_t i) const;

  Flight flight_;
  Rule rule_;
  Queue queue_;
  std::vector<Body> body_;
  std::vector<Eigen::Vector3d> spin_;
  double base_ = 0;          ///< absolute time of time 0 [s]
  double now_ = 0;           ///< relative
  double renew_at_ = 0;      ///< relative, at the latest
  long collisions_left_ = 0;  ///< until the next renewal
  static constexpr double collapsed = 1e-7;  ///< of the longest time that as many collisions have taken
  long watched_ = 0;                          ///< collisions since
  double watched_from_ = 0;                   ///< this absolute time [s]
  double longest_watch_ = 0;                  ///< [s]
  EventTotals totals_;
  std::uint64_t queue_operations_ = 0;  ///< before the last renewal
};

}  // namespace scalebreak
