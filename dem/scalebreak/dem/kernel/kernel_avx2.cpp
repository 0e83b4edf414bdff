#include <bit>
#include <cmath>
#include <cstring>
#include <experimental/simd>
#include <type_traits>
#include <utility>

#include <scalebreak/contact/stepped_slider.hpp>
#include <scalebreak/dem/kernel/kernel.hpp>

namespace scalebreak::dem::avx2 {
namespace {
namespace stdx = std::experimental;
#include "kernel_body.hpp"
}  // namespace

extern const Kernel kernel;
const Kernel kernel{"avx2", find_contacts, forces, move, select};

}  // namespace scalebreak::dem::avx2
