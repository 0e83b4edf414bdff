#include <scalebreak/ensembles/event/event_spheres.hpp>

#include <scalebreak/ensembles/event/event_spheres_balls.hpp>
#include <scalebreak/ensembles/event/event_spheres_loop.hpp>
#include <scalebreak/ensembles/event/event_spheres_patch_state.hpp>
#include <scalebreak/ensembles/event/event_spheres_patches.hpp>
#include <scalebreak/ensembles/event/event_spheres_state.hpp>
#include <scalebreak/ensembles/event/queue/reference_queue.hpp>
#include <scalebreak/ensembles/event/rules/constant_restitution.hpp>

namespace scalebreak {

template class EventSpheres<CalendarQueue, SmoothRule>;
template class EventSpheres<CalendarQueue, RoughRule>;
template class EventSpheres<ReferenceQueue, SmoothRule>;
template class EventSpheres<ReferenceQueue, RoughRule>;

}  // namespace scalebreak
