#include "shared.hpp"

double sum_here(const double* values, int count) { return sum_of(values, count); }
