#pragma once

#include <scalebreak/contact/hertz.hpp>
#include <scalebreak/contact/jkr.hpp>
#include <scalebreak/contact/linear.hpp>
#include <scalebreak/contact/normal_terms.hpp>

namespace scalebreak {

/// The registry of normal laws: words, kinds, the exact engines, the tables and the kernels of the soft spheres follow from it. The forms of
/// one law stand together.
using NormalLaws = LawList<Linear, Hertz, JkrOnRadius, JkrOnOverlap>;

}  // namespace scalebreak
