#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <experimental/simd>
#include <limits>

#include <scalebreak/base/scalar.hpp>

namespace scalebreak {
namespace {

TEST(InverseCubeRoot, OfPacksIsRightToTwoUnitsInTheLastPlace) {
  using Pack = std::experimental::native_simd<double>;
  double worst = 0;
  for (double x = 1e-290; x < 1e290; x *= 1.0137) {
    const long double right = 1 / std::cbrt(static_cast<long double>(x));
    const double found = inverse_cube_root(Pack(x))[0];
    worst = std::max(worst, static_cast<double>(std::abs(found / right - 1)));
  }
  EXPECT_LT(worst, 2 * std::numeric_limits<double>::epsilon());
}

}  // namespace
}  // namespace scalebreak
