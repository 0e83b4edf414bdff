#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/event_spheres_balls.hpp>
#include <scalebreak/ensembles/event/event_spheres_loop.hpp>
#include <scalebreak/ensembles/event/event_spheres_patch_state.hpp>
#include <scalebreak/ensembles/event/event_spheres_patches.hpp>
#include <scalebreak/ensembles/event/event_spheres_state.hpp>
#include <scalebreak/ensembles/event/rules/table_rule.hpp>

namespace scalebreak {

template class EventSpheres<CalendarQueue, TableRule>;

}  // namespace scalebreak
