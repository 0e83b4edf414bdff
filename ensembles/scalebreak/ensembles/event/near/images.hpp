#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

#include <scalebreak/cell/cell.hpp>

namespace scalebreak {

/// A sphere as another one sees it: its number and which of its images.
class Neighbour {
 public:
  static constexpr int image_bits = 6;  ///< the lowest

  Neighbour() = default;
  constexpr Neighbour(std::uint32_t sphere, std::uint32_t image) : word_(sphere << image_bits | image) {}
  [[nodiscard]] constexpr std::uint32_t sphere() const { return word_ >> image_bits; }
  [[nodiscard]] constexpr std::uint32_t image() const { return word_ & ((1u << image_bits) - 1); }

  friend bool operator==(const Neighbour&, const Neighbour&) = default;

 private:
  std::uint32_t word_ = 0;
};
inline constexpr std::uint32_t most_flying_spheres = (1u << 26) - 16;  ///< the rest stand for walls and for no sphere

/// The images of a cell: up to three along x either way, as a sheared cell moves on without its spheres being brought back, and one
/// along y and z.
class Images {
 public:
  struct Image {
    Eigen::Vector3d shift;  ///< at time 0 [m]
    double drift = 0;       ///< velocity along x [m/s]

    [[nodiscard, gnu::always_inline]] Eigen::Vector3d shift_at(double time) const {
      return {shift.x() + time * drift, shift.y(), shift.z()};
    }
  };
  static constexpr int most_along_x = 3;

  explicit Images(const Cell& cell) {
    for (int x = -most_along_x; x <= most_along_x; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          image_[code(x, y, z)] = {{x * cell.size.x() + z * cell.shear_offset, y * cell.size.y(), z * cell.size.z()},
                                   z * cell.shear_rate * cell.size.z()};
        }
      }
    }
  }

  [[nodiscard, gnu::always_inline]] const Image& operator[](std::uint32_t code) const { return image_[code]; }
  [[nodiscard]] static constexpr std::uint32_t code(int x, int y, int z) {
    return static_cast<std::uint32_t>((z + 1) * 3 * (2 * most_along_x + 1) + (y + 1) * (2 * most_along_x + 1) + x + most_along_x);
  }
  static constexpr std::uint32_t home = (9 * (2 * most_along_x + 1) - 1) / 2;  ///< the sphere itself
  /// The image of the first sphere as the second sees it, where the first sees this one of the second.
  [[nodiscard]] static constexpr std::uint32_t opposite(std::uint32_t code) { return 9 * (2 * most_along_x + 1) - 1 - code; }

 private:
  std::array<Image, 64> image_;
};

}  // namespace scalebreak
