#pragma once

#include <scalebreak/scene/given.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// Do the words of [contact] go together? Puts those that make no difference into their one form. Throws InputError.
void check_contact(Input& input, const Given& given);

/// Has each pair that can meet what the laws of [contact] work with: adhesion, liquid? Throws InputError.
void check_surfaces(const Input& input, const Given& given);

}  // namespace scalebreak
