#pragma once

#include <scalebreak/scene/given.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// Do the kind of a cell, its boundaries, what drives it and gravity go together? Fills in what depends on its kind. Throws InputError.
void complete_and_check_cell(Input& input, const Given& given);

/// Do the spheres fit into the cell, and are they not too many? Throws InputError.
void check_room(const Input& input, const Given& given);

/// Does the run end, by its duration or its strain? Fills in the defaults. Throws InputError.
void complete_and_check_run(Input& input, const Given& given);

}  // namespace scalebreak
