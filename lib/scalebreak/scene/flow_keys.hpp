#pragma once

#include <string>
#include <vector>

#include <scalebreak/scene/keys.hpp>

namespace scalebreak {

/// Each appends the keys of a section; all but run.duration stand in a flow only.
void add_particles(std::vector<Key>& list);
void add_cell(std::vector<Key>& list);
void add_run(std::vector<Key>& list);
void add_output(std::vector<Key>& list);

}  // namespace scalebreak
