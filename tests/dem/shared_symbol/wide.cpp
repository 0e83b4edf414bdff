#include "shared.hpp"

double sum_there(const double* values, int count) { return sum_of(values, count); }
