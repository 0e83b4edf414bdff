#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <scalebreak/collisions/bodies/few_bodies.hpp>
#include <scalebreak/contact/normal_point.hpp>
#include <scalebreak/contact/slider.hpp>

// The motion of a few bodies between events. Internal to the exact engine; see move_bodies.

namespace scalebreak {

/// Two bodies between which something acts, and how: what stays the same between events.
struct Link {
  int first = 0, second = 0;
  std::size_t pair = 0;
  bool touching = false;
  bool rooted = false;  ///< the overlap is carried as δ^{1/4}: a law is smooth in that alone
  bool bridged = false;
  bool near = true;            ///< the liquid's separation is at its least
  bool second_branch = false;  ///< of the rolling drag
  Grip slide = Grip::holds, roll = Grip::holds;
  double load_sign = 1;  ///< F_N is this times the law's load
  bool outgoing = false;
  int turn_backs = 0;
  Eigen::Vector3d normal_at_touch{0, 0, 0};

  bool operator==(const Link&) const = default;
};

/// What happens to a link, in the order of its event values.
enum class LinkEvent { phase_end, phase_begin, slide, skid, roll, load_sign, near, branch, turn, count };

/// Where time stands still (a Hertz contact's begin and end, a root at zero overlap) several contacts at once could neither begin nor
/// end: they do so at this share of their coordinate, of which the fourth power is the overlap.
inline constexpr double begin_share = 1e-4, end_share = 1e-5;
[[nodiscard]] inline bool flat_touch(const ContactLaws& laws) {
  return std::visit([](const auto& law) { return law.overlap_slope(law.touch()) == 0; }, laws.normal);
}

/// Where the limit of a slider falls to zero its direction turns ever faster, to no effect: below this share of the limit's
/// size in the scene it is let be, which costs an impulse of the square of this.
inline constexpr double direction_floor = 1e-6;

/// State: position, velocity and spin of each body; then a block per link; then the time. The integrator's
/// variable s runs so that all of it is smooth in s: dt/ds falls to zero where a contact begins or tears.
class FewBodySystem {
 public:
  using State = std::vector<double>;
  using Values = std::vector<double>;

  FewBodySystem(std::vector<MovingBody> bodies, const std::function<MappedLaws(int, int)>& laws, double duration);

  // For EventIntegrator:
  void operator()(const State& y, State& rate, double s);
  void event_values(const State& y, Values& values);
  [[nodiscard]] double scale(std::size_t i) const { return scale_[i]; }

  /// What an event means: the links and modes change, and with them the state.
  struct Change {
    ContactChange what;
    int first, second;
  };
  /// Carries out event `k`; what changed, for those who want to know. Sets `duration_over` for the last event.
  std::vector<Change> apply(std::size_t k, State& y);

  /// The bodies whose contact event `k` is of, or −1 if it is of none.
  [[nodiscard]] std::array<int, 2> bodies_of(std::size_t k) const;

  [[nodiscard]] State start() const;
  [[nodiscard]] std::vector<MovingBody> bodies(const State& y) const;
  [[nodiscard]] EnergyAccount account(const State& y);
  [[nodiscard]] const std::vector<Link>& links() const { return links_; }
  [[nodiscard]] double largest_overlap(const State& y) const;
  [[nodiscard]] double largest_depth(const State& y) const;  ///< overlap over R*
  /// The contact with the largest overlap over the smaller radius of its bodies.
  struct Deepest {
    int first = 0, second = 0;
    double overlap = 0, radius = 1;
  };
  [[nodiscard]] Deepest deepest(const State& y) const;
  [[nodiscard]] double largest_force(const State& y);
  [[nodiscard]] std::vector<ContactState> contacts(const State& y);
  [[nodiscard]] double turned(const State& y, const Link& link) const;
  [[nodiscard]] double time(const State& y) const { return y.back(); }
  [[nodiscard]] double time_unit() const { return time_unit_; }
  /// Time per unit of the integrator's variable.
  [[nodiscard]] double time_rate(const State& y) {
    evaluate(y);
    return time_rate_;
  }
  [[nodiscard]] bool duration_over() const { return duration_over_; }
  [[nodiscard]] long force_evaluations() const { return force_evaluations_; }

  /// Links what touches at the start without approach, and attracts: it begins to pull.
  void begin(State& y, std::vector<Change>& changes);
  /// Without links: moves on to the next touch and links it; false if there is none before the end.
  bool fly(State& y, std::vector<Change>& changes);
  /// No contact can ever part: each lacks more energy for it than all that moves could give.
  [[nodiscard]] bool rests(const State& y) const;

 private:
  enum Block : std::size_t {
    root,
    coordinate,
    slide,
    roll = slide + 3,
    damping_work = roll + 3,
    tangential_work,
    rolling_work,
    liquid_work,
    block_size
  };

  [[nodiscard]] static Eigen::Vector3d at(const State& y, std::size_t i) { return {y[i], y[i + 1], y[i + 2]}; }
  static void put(State& y, std::size_t i, const Eigen::Vector3d& v) {
    for (Eigen::Index k = 0; k < 3; ++k) y[i + static_cast<std::size_t>(k)] = v[k];
  }
  [[nodiscard]] std::size_t body_at(std::size_t body) const { return 9 * body; }
  [[nodiscard]] std::size_t link_at(std::size_t link) const { return 9 * bodies_.size() + block_size * link; }
  [[nodiscard]] std::size_t pair_index(std::size_t i, std::size_t j) const;
  [[nodiscard]] bool linked(std::size_t pair) const { return link_of_[pair] >= 0; }

  struct Geometry {
    Eigen::Vector3d normal, velocity;  ///< from first to second; of the first relative to the second
    double distance, gap;
  };
  /// One link at one state. Surface quantities are those of the original pair; u = ω × n.
  struct Evaluated {
    Geometry at;
    double approach = 0;
    Eigen::Vector3d normal_rate{0, 0, 0}, centres{0, 0, 0};
    std::array<Eigen::Vector3d, 2> turning{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    std::array<double, 2> arm{0, 0};
    double arm_rate = 0;
    // The normal contact:
    double coordinate = 0, root = 0;
    NormalPoint normal;
    double shrink = 1;         ///< 1/√(slope² + its reference²)
    double others = 1;         ///< product of the other links' slope·shrink
    ContactPoint point, rate;  ///< with F_N positive
    // The liquid, and all together:
    double separation = 0, capillary = 0, drag = 0;
    Eigen::Vector3d wet{0, 0, 0};
    SliderLaw slide_law, roll_law;
    Slider<3> slide, roll;
    Eigen::Vector3d slide_speed{0, 0, 0}, roll_speed{0, 0, 0}, slide_acceleration{0, 0, 0}, roll_acceleration{0, 0, 0};
    double normal_force = 0;                             ///< of the original pair, repulsion positive
    Eigen::Vector3d friction{0, 0, 0}, torque{0, 0, 0};  ///< against the motion of the first body
  };
  [[nodiscard]] Geometry geometry(const State& y, std::size_t i, std::size_t j) const;

  [[nodiscard]] double scaled_overlap(const State& y, std::size_t link) const;
  void set_units();
  /// Of the state and the links that it was of last, it does nothing.
  void evaluate(const State& y);
  void evaluate_geometry(const State& y, const Link& link, std::size_t at, Evaluated& e) const;
  void evaluate_normal(const State& y, const Link& link, std::size_t at, Evaluated& e) const;
  void evaluate_forces(const State& y, const Link& link, std::size_t at, Evaluated& e) const;
  void add_forces(const Link& link, const Evaluated& e);
  void hold_rigid_rolling(const State& y);
  void stop_rigid_rolling(State& y) const;
  [[nodiscard]] std::vector<std::size_t> rigidly_held() const;
  [[nodiscard]] double torque_share(const Link& link, const Link& other) const;
  [[nodiscard]] Eigen::VectorXd holding_torques(const std::vector<std::size_t>& held, const Eigen::VectorXd& missing) const;
  [[nodiscard]] Eigen::VectorXd around_loops(const std::vector<std::size_t>& held, const Eigen::MatrixXd& effect,
                                             const Eigen::VectorXd& missing) const;
  void finish_rates(const State& y, const Link& link, std::size_t at, Evaluated& e) const;
  [[nodiscard]] Eigen::Vector3d rigid_turning(const Link& link, const Evaluated& e) const;
  [[nodiscard]] double roll_event(const Link& link, const Evaluated& e) const;

  void touch(State& y, std::size_t i, std::size_t j, std::vector<Change>& changes);
  void first_modes(State& y, std::size_t link);
  void separate(State& y, std::size_t link, std::vector<Change>& changes);
  void remove(State& y, std::size_t link);
  void set_slide(State& y, std::size_t link, const Slider<3>& slider, std::vector<Change>& changes);
  void set_roll(State& y, std::size_t link, const Slider<3>& slider, std::vector<Change>& changes);
  void change_roll(State& y, std::size_t link, std::vector<Change>& changes);
  void relink();

  std::vector<MovingBody> bodies_;
  std::vector<MappedLaws> laws_;  ///< of all pairs
  struct PairScales {
    double overlap = 0, root = 0, coordinate = 0;  ///< of the original pair, at the scene's speed
    double slope = 0, root_slope = 0;              ///< of the overlap there
    double roll = 1;                               ///< of the rolling history
    double depth = 0;                              ///< of the normal potential's well [J]
    double force = 0;                              ///< of the normal law there
  };
  std::vector<PairScales> scales_;
  double duration_;
  bool duration_over_ = false;
  double speed_unit_ = 0, time_unit_ = 0, length_unit_ = 0, energy_unit_ = 0;
  std::vector<Link> links_;
  std::vector<int> link_of_;  ///< by pair, −1 without
  std::vector<double> scale_;
  std::vector<Evaluated> evaluated_;
  State evaluated_state_;              ///< of which `evaluated_` is; empty: of none
  std::vector<Link> evaluated_links_;  ///< as they were then
  std::vector<Eigen::Vector3d> acceleration_, spin_rate_;
  double time_rate_ = 1;
  EnergyAccount spent_;  ///< by links that are no more
  long force_evaluations_ = 0;
};

}  // namespace scalebreak
