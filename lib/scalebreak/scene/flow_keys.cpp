#include <scalebreak/scene/flow_keys.hpp>

#include <scalebreak/scene/key_makers.hpp>

namespace scalebreak {
namespace {

/// The keys of a section whose values lie in one part of the input.
template <class Part>
struct Section {
  std::vector<Key>& list;
  std::string name;
  Part Input::*part;

  void number(const char* key, const char* unit, const char* meaning, double Part::*member) const {
    list.push_back(scalebreak::number(name, key, unit, meaning, [=, *this](Input& input) -> double& { return input.*part.*member; }));
  }
  void whole(const char* key, const char* meaning, std::uint64_t Part::*member) const {
    list.push_back(whole_number(name, key, meaning, [=, *this](Input& input) -> std::uint64_t& { return input.*part.*member; }));
  }
  void vector(const char* key, const char* unit, const char* meaning, Eigen::Vector3d Part::*member) const {
    list.push_back(vector3(name, key, unit, meaning, [=, *this](Input& input) -> Eigen::Vector3d& { return input.*part.*member; }));
  }
  template <class Enum, std::size_t count>
  void word(const char* key, const char* meaning, const char* const (&words)[count], Enum Part::*member) const {
    list.push_back(choice_of(name, key, meaning, words_of(words), part, member));
  }
  /// Any number of them, each at most once; or, of an array of fixed length, one for each place.
  template <class List, std::size_t count>
  void words(const char* key, const char* meaning, const char* const (&all)[count], List Part::*member) const {
    using Enum = typename List::value_type;
    constexpr bool fixed = requires { std::tuple_size<List>::value; };
    std::size_t least = 0, most = count;
    if constexpr (fixed) least = most = std::tuple_size_v<List>;
    const auto put = [=, *this](Input& input, const std::vector<std::size_t>& chosen) {
      List& target = input.*part.*member;
      if constexpr (!fixed) target.resize(chosen.size());
      for (std::size_t i = 0; i < chosen.size(); ++i) target[i] = static_cast<Enum>(chosen[i]);
    };
    const auto take = [=, *this](const Input& input) {
      std::vector<std::size_t> chosen;
      for (const Enum item : input.*part.*member) chosen.push_back(static_cast<std::size_t>(item));
      return chosen;
    };
    list.push_back(choices(name, key, meaning, words_of(all), least, most, put, take));
  }
};

}  // namespace

void add_particles(std::vector<Key>& list) {
  const Section<Particles> add{list, "particles", &Input::particles};
  add.whole("count", "number of spheres; 0: follows from volume_fraction and cell.size", &Particles::count);
  add.number("radius", "m", "mean radius; of a bidisperse scene that of the small ones", &Particles::radius);
  add.number("volume_fraction", "-", "volume of the solids over that of the cell; 0: follows from count and cell.size",
             &Particles::volume_fraction);
  add.word("size", "distribution of the radii, by number; a gaussian is cut at 3 standard deviations", size_kind_words, &Particles::size);
  add.number("size_spread", "-", "standard deviation over mean of the radius (gaussian: at most 0.3; lognormal)", &Particles::size_spread);
  add.number("large_radius", "m", "radius of the large ones, of the material [second] (bidisperse)", &Particles::large_radius);
  add.number("large_mass_fraction", "-", "mass of the large ones over that of all (bidisperse)", &Particles::large_mass_fraction);
  add.number("speed", "m/s", "root of the mean squared velocity about the mean flow at the start", &Particles::speed);
  list.push_back(
      {"particles", "file", "-", "a particle file to start from, which says all of the above and the cell's size; \"\": random places",
       "the path of a file, as a string", [](Input& input, const Value& value) { input.particles.file = expect<std::string>(value); },
       [](const Input& input) { return Value(input.particles.file); }});
}

void add_cell(std::vector<Key>& list) {
  const Section<CellInput> add{list, "cell", &Input::cell};
  add.word("kind",
           "homogeneous shear across periodic faces, shear between moving walls, a gas that cools, a box, homogeneous shear at a height "
           "that follows a pressure: the flow is along x, its gradient along z",
           cell_kind_words, &CellInput::kind);
  add.vector("size", "m", "lengths of the edges; 0: a cube that follows from count and volume_fraction", &CellInput::size);
  add.words("boundary", "of the faces along x, y and z", boundary_words, &CellInput::boundary);
  add.number("shear_rate", "1/s", "rate of the mean flow (shear, confined_shear); 0 elsewhere", &CellInput::shear_rate);
  add.number("wall_speed", "m/s", "the walls along z move at plus and minus this along x", &CellInput::wall_speed);
  list.push_back(flag("cell", "wall_no_slip", "a sphere loses its spin when it touches a wall",
                      [](Input& input) -> bool& { return input.cell.wall_no_slip; }));
  add.number("pressure", "Pa", "normal stress across the gradient that the height of the cell follows (confined_shear); 0 elsewhere",
             &CellInput::pressure);
  add.vector("gravity", "m/s2", "acceleration of a free sphere", &CellInput::gravity);
}

void add_run(std::vector<Key>& list) {
  const Section<RunInput> add{list, "run", &Input::run};
  add.number("duration", "s",
             "time that is followed; of a flow 0: strain holds, of bodies 0: until they have parted for good or rest in contact",
             &RunInput::duration);
  add.number("strain", "-", "the same times the shear rate; 0: duration holds", &RunInput::strain);
  add.number("warmup_duration", "s", "time before it that is not measured; 0: warmup_strain holds", &RunInput::warmup_duration);
  add.number("warmup_strain", "-", "the same times the shear rate; 0: warmup_duration holds", &RunInput::warmup_strain);
  add.whole("seed", "of all random numbers", &RunInput::seed);
  add.number("step_fraction", "-", "step of the soft-sphere engine over the Rayleigh time of the smallest sphere (docs/default_step.md)",
             &RunInput::step_fraction);
  list.push_back(flag("run", "step_bounds", "keep that step within a thirtieth of the contact time, and an oscillation of a linear contact",
                      [](Input& input) -> bool& { return input.run.step_bounds; }));
  add.whole("replicas", "runs that differ in their random numbers alone", &RunInput::replicas);
  add.word("integrator", "velocity Verlet as it is, or with velocities brought up to the time of the forces", integrator_words,
           &RunInput::integrator);
}

void add_output(std::vector<Key>& list) {
  const Section<OutputInput> add{list, "output", &Input::output};
  add.number("interval", "s", "time between rows of the series, and particle files; 0: about 200 over the run", &OutputInput::interval);
  add.words("fields", "what particle files hold beside identity and position", particle_field_words, &OutputInput::fields);
  add.words("formats", "formats of particle files: CSV, ParaView, extended XYZ, LAMMPS dump; empty: no such files", particle_format_words,
            &OutputInput::formats);
  add.number("checkpoint_interval", "s", "wall time between checkpoints; 0: none", &OutputInput::checkpoint_interval);
}

}  // namespace scalebreak
