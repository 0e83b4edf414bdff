#pragma once

#include <vector>

#include <scalebreak/scene/keys.hpp>

namespace scalebreak {

/// The keys of [advise].
void add_advise(std::vector<Key>& list);

}  // namespace scalebreak
