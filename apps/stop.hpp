#pragma once

namespace scalebreak::apps {

/// From now on the first SIGINT or SIGTERM is kept for `told_to_stop`; a second one ends the program at once.
void stop_on_signals();

/// Has one come?
[[nodiscard]] bool told_to_stop();

}  // namespace scalebreak::apps
