#pragma once

#include <optional>

#include <scalebreak/ensembles/prediction/cooling_gas.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// A flow in the numbers that kinetic theory asks for, of the scaled system. Of two sizes the one of mean volume, of [material].
struct FlowConditions {
  double diameter = 0;         ///< [m]
  double density = 0;          ///< of the spheres [kg/m³]
  double volume_fraction = 0;  ///< solids over the cell
  double shear_rate = 0;       ///< mean [1/s]; 0: the flow is not sheared
  double speed = 0;  ///< root mean square about the mean flow that is known: of the start, of what it falls through, or advise.speed [m/s]
  bool speed_is_told = false;       ///< by advise.speed: then kinetic theory is not asked
  double pressure = 0;              ///< that is imposed [Pa]; 0: none
  double gravity = 0;               ///< [m/s²]
  double length = 0;                ///< the shortest edge of the cell [m]
  double length_along_gravity = 0;  ///< [m]
  double begin = 0, end = 0;        ///< of the measurement after the start, where they are told as times [s]
};
[[nodiscard]] FlowConditions flow_conditions(const Input& input);

/// What carries a flow, which decides what is known of it.
enum class FlowRegime {
  collisional,  ///< sheared, and collisions carry the pressure: what the prediction is fitted to
  pressed,      ///< sheared under a pressure that lasting contacts carry
  cooling,      ///< neither sheared nor pulled down
  resting,      ///< pulled down by gravity, not sheared
};

/// The dimensionless numbers of a flow under the scaling law of its input, by which laws break, all known before it runs.
struct ScaleGroups {
  double size = 1;            ///< how much larger the spheres are than the original's, l
  double torque_lack = 0;     ///< by how many powers of l the torque of a direct-force law falls short of its force at the larger radius
  double temperature = 0;     ///< granular, expected [m²/s²]
  double impact_speed = 0;    ///< mean along the line of centres [m/s]
  double contact_time = 0;    ///< at that speed, by the exact engine; of a pair that sticks there, at twice its sticking speed [s]
  double overlap = 0;         ///< the largest of that collision over R*
  double collision_rate = 0;  ///< of a sphere [1/s]
  double busy = 0;            ///< contact time × collision rate: how far from binary
  double jamming_share = 0;   ///< of how often spheres meet, what comes from being near jamming
  double impact_over_sticking = 0;  ///< impact speed / sticking speed; infinite where nothing can stick; of a cooling gas at the end
  double bond = 0;               ///< pull-off force over pressure × d², or over weight where nothing presses; 0: no adhesion, or neither
  double inertial_number = 0;    ///< γ̇ d √(ρ/pressure); 0: no shear
  double length_ratio = 0;       ///< diameter over the cell's shortest edge
  double collisional_share = 0;  ///< of the pressure: 1 in shear at constant volume, 0 where nothing is sheared
  FlowRegime regime = FlowRegime::collisional;
  CoolingGas gas;     ///< of a cooling gas, at its start
  double cooled = 0;  ///< of a cooling gas: its speeds end at 1/(1 + cooled) of those at the start; of smooth spheres time over Haff's
  double pressed_overlap =
      0;  ///< of a contact that carries pressure × d², over R*; the pressure is the imposed one, or that of the weight above
  bool sheared = false;
  bool jammed = false;  ///< the volume fraction is beyond what flows: numbers are those of the densest flow
};

/// Throws InputError where the input is no flow.
[[nodiscard]] ScaleGroups scale_groups(const Input& input);

/// The densest flow that theory is asked for is so far below jamming.
inline constexpr double below_jamming = 0.005;

/// The same scene without a scaling law.
[[nodiscard]] Input original_of(Input input);

}  // namespace scalebreak
