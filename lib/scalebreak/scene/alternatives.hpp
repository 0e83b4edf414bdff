#pragma once

#include <string>

#include <scalebreak/material/material.hpp>
#include <scalebreak/scene/given.hpp>

namespace scalebreak {

// A material has one thing said in two ways: its liquid as a share of the solids or as a volume, its least separation as a
// length or as a share of the radius. The first counts where it is above 0, the other elsewhere.

/// Of two such keys the one counts that was given in this section, whatever was there before; what does not count goes back to
/// its default, so that materials that behave the same are the same.
void settle_alternatives(Material& material, const std::string& section, const Given& given);

/// Throws InputError where both were given in one section, and both would count.
void check_alternatives(const std::string& section, const Given& given);

/// Does this key of a material not count?
[[nodiscard]] bool overruled(const Material& material, const std::string& name);

}  // namespace scalebreak
