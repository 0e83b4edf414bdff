#include <scalebreak/table/table_row.hpp>

#include <bit>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

namespace scalebreak {
namespace {

// A cell is named by a double's exponent and the first two bits of its mantissa.
constexpr int cell_shift = 50;
constexpr std::uint64_t bits_of_one = std::bit_cast<std::uint64_t>(1.0);

std::uint64_t cell_of(double value) { return std::bit_cast<std::uint64_t>(value) >> cell_shift; }
double cell_start(std::uint64_t cell) { return std::bit_cast<double>(cell << cell_shift); }

/// Where in its cell a number lies, from −1 to 1: the rest of its mantissa.
double place_in_cell(double value) {
  const std::uint64_t rest = std::bit_cast<std::uint64_t>(value) << 2 & 0x000f'ffff'ffff'ffffULL;
  return 2 * std::bit_cast<double>(rest | bits_of_one) - 3;
}

}  // namespace

TableRow::TableRow(double sticking_squared, const std::function<TableOutcome(double)>& at) : sticking_squared_(sticking_squared) {
  constexpr int points = degree + 1;
  using Square = Eigen::Matrix<double, points, points>;
  Eigen::Matrix<double, points, 1> place;
  Square powers;
  for (int i = 0; i < points; ++i) {
    place[i] = std::cos(std::numbers::pi * (i + 0.5) / points);  // Chebyshev's
    for (int k = 0; k < points; ++k) powers(i, k) = std::pow(place[i], k);
  }
  const Square to_coefficients = powers.inverse();
  first_cell_ = cell_of(TableBounds::excess_min);
  cells_.resize(cell_of(TableBounds::excess_max) - first_cell_ + 1);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const double low = cell_start(first_cell_ + c), high = cell_start(first_cell_ + c + 1);
    Eigen::Matrix<double, points, 4> values;
    for (int i = 0; i < points; ++i) {
      const TableOutcome outcome = at((low + high) / 2 + (high - low) / 2 * place[i]);
      values.row(i) << outcome.restitution, outcome.contact_time, outcome.max_overlap, 0;
    }
    const Eigen::Matrix<double, points, 4> coefficients = to_coefficients * values;
    for (int k = 0; k < points; ++k) cells_[c][static_cast<std::size_t>(k)] = coefficients.row(k).transpose();
  }
}

double TableRow::sticking_speed() const { return std::sqrt(sticking_squared_); }

std::optional<TableOutcome> TableRow::find(double speed) const {
  if (cells_.empty()) return scale_free_;
  const double excess = speed * speed - sticking_squared_;
  const double margin = TableBounds::margin(sticking_squared_);
  if (excess < -margin) return TableOutcome{.stuck = true};
  if (!(excess >= margin && excess <= TableBounds::excess_max)) return std::nullopt;
  const Cell& cell = cells_[cell_of(excess) - first_cell_];
  const double u = place_in_cell(excess);
  Value sum = cell[degree];
  for (int k = degree - 1; k >= 0; --k) sum = sum * u + cell[static_cast<std::size_t>(k)];
  return TableOutcome{false, sum[0], sum[1], sum[2]};
}

}  // namespace scalebreak
