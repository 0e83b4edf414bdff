#pragma once

#include <exception>

#include <omp.h>

namespace scalebreak {

/// Runs job(i) for i in [0, count) on `threads` cores (0: all); each job writes its own slot, so that the result is
/// the same for any number. The first failure is thrown here.
template <class Index, class Job>
void parallel_for(Index count, int threads, const Job& job) {
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads > 0 ? threads : omp_get_max_threads())
  for (Index i = 0; i < count; ++i) {
    try {
      job(i);
    } catch (...) {
#pragma omp critical
      if (!failure) failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace scalebreak
