#include <scalebreak/dem/kernel/kernel.hpp>

#include <cstring>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak::dem {
namespace baseline {
extern const Kernel kernel;
}
namespace avx2 {
extern const Kernel kernel;
}
namespace avx512 {
extern const Kernel kernel;
}

namespace {

bool runs(const Kernel& kernel) {
  if (&kernel == &avx512::kernel)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  if (&kernel == &avx2::kernel) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  return true;
}

}  // namespace

const Kernel& kernel(const char* name) {
  for (const Kernel* kernel : {&avx512::kernel, &avx2::kernel, &baseline::kernel}) {
    if (name && std::strcmp(name, kernel->name) != 0) continue;
    if (runs(*kernel)) return *kernel;
    if (name) throw InputError(fmt::format("this processor does not run the kernel \"{}\"", name));
  }
  throw InputError(fmt::format("there is no kernel \"{}\"; allowed: baseline, avx2, avx512", name));
}

const Kernel& kernel_for_few() { return runs(avx2::kernel) ? avx2::kernel : baseline::kernel; }

}  // namespace scalebreak::dem
