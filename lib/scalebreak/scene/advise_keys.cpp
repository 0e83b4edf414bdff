#include <scalebreak/scene/advise_keys.hpp>

#include <scalebreak/scene/key_makers.hpp>

namespace scalebreak {

void add_advise(std::vector<Key>& list) {
  const auto add = [&](const char* name, const char* unit, const char* meaning, double AdviseInput::*member) {
    list.push_back(number("advise", name, unit, meaning, [member](Input& input) -> double& { return input.advise.*member; }));
  };
  add("tolerance", "-", "largest relative error, with its uncertainty, of every quantity that a scaling law is judged by",
      &AdviseInput::tolerance);
  add("speed", "m/s", "root mean square about the mean flow; 0: by kinetic theory in shear, else of the start", &AdviseInput::speed);
  add("shear_rate", "1/s", "of the flow; 0: the scene's", &AdviseInput::shear_rate);
  add("volume_fraction", "-", "solids over the cell; 0: the scene's", &AdviseInput::volume_fraction);
  add("pressure", "Pa", "that holds the flow together; 0: cell.pressure, or what collisions make", &AdviseInput::pressure);
  add("size", "m", "radius of the spheres; 0: the scene's", &AdviseInput::size);
}

}  // namespace scalebreak
