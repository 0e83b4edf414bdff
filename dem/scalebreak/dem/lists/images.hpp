#pragma once

#include <array>

#include <scalebreak/cell/cell.hpp>
#include <scalebreak/dem/kernel/kernel.hpp>

namespace scalebreak::dem {

/// Where the 27 images of a cell lie and how they move; see no_image for their numbers. The last place is nowhere.
struct Images {
  std::array<Quad, image_places> shift, velocity;

  /// `offset` is that of the image above along x, which may go on beyond the cell's edge [m].
  Images(const Cell& cell, double offset) {
    for (int number = 0; number < 27; ++number) {
      const int x = number % 3 - 1, y = number / 3 % 3 - 1, z = number / 9 - 1;
      const auto k = static_cast<std::size_t>(number);
      shift[k] = {x * cell.size.x() + z * offset, y * cell.size.y(), z * cell.size.z(), 0};
      velocity[k] = {z * cell.shear_rate * cell.size.z(), 0, 0, 0};
    }
    shift.back() = {1e100, 0, 0, 0};
  }
};

/// The image offset of a sheared cell nearest to zero.
[[nodiscard]] inline double central_offset(const Cell& cell) {
  return cell.shear_offset > cell.size.x() / 2 ? cell.shear_offset - cell.size.x() : cell.shear_offset;
}

}  // namespace scalebreak::dem
