#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <scalebreak/ensembles/event/event_totals.hpp>
#include <scalebreak/ensembles/event/flight/flight.hpp>
#include <scalebreak/ensembles/event/flight/foresee.hpp>
#include <scalebreak/ensembles/event/patches/patch.hpp>
#include <scalebreak/ensembles/event/queue/calendar_queue.hpp>
#include <scalebreak/ensembles/event/rules/collision_rule.hpp>
#include <scalebreak/measure/contact_force.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

struct EventSetup {
  Eigen::Vector3d gravity{0, 0, 0};  ///< acceleration [m/s²]
  double allowance = 0;              ///< how far a sphere goes before its list is made anew [m]; 0: what is fast at this volume fraction
  /// Laws of the spheres where more than two meet, or what the rule leaves; null: everything is a collision of two. A rule that `lasts`.
  const GroupLaws* groups = nullptr;
};

/// Spheres that fly freely between collisions that take no time: the event-driven engine, with one future event a sphere. What a
/// sphere foresees is what it meets first among its neighbours as they fly now; whoever's path changes looks anew at all of its
/// neighbours, so that of each pair at least one has in its event a time not after that of their meeting.
///
/// With `groups`, spheres of which a third comes near before a contact of two has ended, or whose collision the rule does not resolve, are a
/// patch: integrated in stretches of some steps, behind the flow's time, each sphere a ball about its line that holds all it may do until the
/// next stretch. Who comes into a ball joins; what neither touches nor will leaves. A pair whose contact is found disturbed is taken back to
/// its first touch.
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
  /// Makes patches of all contacts that last, so that system() is as soft spheres are and says what touches.
  void open_contacts();
  /// What touches at this time, by identity: in patches, and in contacts that were put as instants. Branches and forces are not told: zero.
  [[nodiscard]] std::vector<ContactForce> touching() const;
  [[nodiscard]] std::size_t patched() const;    ///< spheres in patches
  [[nodiscard]] double elastic_energy() const;  ///< of all patches [J]
  [[nodiscard]] double mean_neighbours() const;
  [[nodiscard]] const Cell& cell() const { return flight_.cell; }
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

  static constexpr std::uint32_t no_patch = 0xffffffff;

  void look_ahead(std::uint32_t i);
  void schedule(std::uint32_t i, const Foreseen& next);
  void happen(std::uint32_t i);
  void collide(std::uint32_t i, Neighbour partner);
  void collide_with_wall(std::uint32_t i, std::uint32_t wall);
  void end_list(std::uint32_t i);
  /// renew_list, with what was kept of the sphere's last collision.
  void list_anew(std::uint32_t i);
  /// Adds what a collision does to the totals; `sign` −1 takes it back.
  void account(const Meeting& meeting, const Parting& parting, double sign);
  [[nodiscard]] Meeting wall_meeting(std::uint32_t wall, const Meeting::Body& body) const;
  /// Brings all to now, which becomes time 0, puts those that are near in space near in memory, and makes lists and events.
  void renew();
  void reorder();
  void watch_for_collapse();

  // event_spheres_patches.hpp, and what is about balls: event_spheres_balls.hpp
  [[nodiscard]] bool patched(std::uint32_t i) const { return groups_ && patch_of_[i] != no_patch; }
  /// Is it in a contact that was put as an instant?
  [[nodiscard]] bool busy(std::uint32_t i) const { return groups_ && encounter_[i].end > now_; }
  void keep_encounter(std::uint32_t i, std::uint32_t partner, double contact_time);
  /// May anything touch one of the two (or the one at a wall) before their contact has ended?
  [[nodiscard]] bool disturbed(std::uint32_t i, std::uint32_t partner, const Parting& parting) const;
  /// Makes a patch of a sphere and what it meets (a sphere, or a wall), with all that they are in contact with, and settles it.
  void crowd(std::uint32_t i, Neighbour partner);
  [[nodiscard]] Patch merged(std::uint32_t i, Neighbour partner);
  /// What a sphere is part of, taken out of the flow; of a sphere that is free, itself as it was at `earliest`, or since when it has been free.
  [[nodiscard]] Patch take_out(std::uint32_t i, double earliest);
  [[nodiscard]] Patch take_back(std::uint32_t i);
  void advance(Patch& patch, double time);
  /// A patch of this time goes on, with what its balls hold already: what has come free leaves, the rest is shown to the flow.
  void settle(Patch&& patch);
  /// Takes it apart and puts its parts as balls into the flow; gives the parts' slots, the first one last.
  [[nodiscard]] std::vector<std::uint32_t> put_down(Patch&& patch);
  [[nodiscard]] std::uint32_t open_slot(Patch&& patch);
  struct Entering {
    std::uint32_t sphere;  ///< of a patch
    Neighbour partner;     ///< what is in its ball
  };
  /// Foresees what will come into the balls of a patch; or gives what is in one of them now, and the patch is to be merged with that.
  [[nodiscard]] std::optional<Entering> show(std::uint32_t slot);
  void put_members(const Patch& patch, double horizon);
  [[nodiscard]] Foreseen foresee_in_patch(std::uint32_t i) const;
  void happen_in_patch(std::uint32_t i);
  void adopt(const std::vector<ContactMemory>& contacts);
  void settle_all();
  void bring_up_patches();
  /// Patches and encounters with the beginning of time set to `time`.
  void carry_patches(double time);
  /// A sphere's last collision with the sphere itself, which was at `position` and is now in another image.
  void carry_encounter(std::uint32_t i, const Eigen::Vector3d& position, const Eigen::Vector3d& velocity);
  void tell_patch(const Patch& patch, System& system) const;
  void save_patches(std::string& bytes) const;
  void load_patches(std::string_view& bytes);
  void renumber_patches(const std::vector<std::uint32_t>& order);
  [[nodiscard]] double longest_stretch() const;
  [[nodiscard]] GroupSphere group_sphere(std::uint32_t i, double time) const;
  /// Everything that is saved and is not a list, the same for both ways.
  template <class Numbers>
  void go_through_numbers(Numbers&& number);
  [[nodiscard]] Meeting::Body meeting_body(std::uint32_t i) const;

  Flight flight_;
  Rule rule_;
  Queue queue_;
  std::vector<Body> body_;
  std::vector<Eigen::Vector3d> spin_;
  const GroupLaws* groups_ = nullptr;
  std::vector<Encounter> encounter_;  ///< of each sphere, where there are groups
  std::vector<std::uint32_t> patch_of_;
  std::vector<std::optional<Patch>> patch_;
  std::vector<std::uint32_t> free_slot_;
  double base_ = 0;                          ///< absolute time of time 0 [s]
  double now_ = 0;                           ///< relative
  double renew_at_ = 0;                      ///< relative, at the latest
  long collisions_left_ = 0;                 ///< until the next renewal
  static constexpr double collapsed = 1e-7;  ///< of the longest time that as many collisions have taken
  long watched_ = 0;                         ///< collisions since
  double watched_from_ = 0;                  ///< this absolute time [s]
  double longest_watch_ = 0;                 ///< [s]
  EventTotals totals_;
  std::uint64_t queue_operations_ = 0;  ///< before the last renewal
};

}  // namespace scalebreak
