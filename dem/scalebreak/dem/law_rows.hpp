#pragma once

#include <cstdint>
#include <vector>

#include <scalebreak/dem/dem.hpp>
#include <scalebreak/dem/spheres.hpp>

namespace scalebreak::dem {

/// The laws between the spheres of a flow, or between them and its walls: a row for each pair of kinds, where there are few kinds of
/// spheres, else a row for each contact.
class LawRows {
 public:
  LawRows() = default;
  /// `each`: a row for each contact. Kinds are radii of the scaled spheres and materials.
  struct Kind {
    double radius;
    std::uint8_t material;
    bool operator==(const Kind&) const = default;
  };
  LawRows(const DemSetup& setup, const std::vector<Kind>& kinds, bool walls, bool each);

  [[nodiscard]] bool one() const { return rows_.size() == 1 && !each_; }
  [[nodiscard]] bool each() const { return each_; }
  [[nodiscard]] std::uint32_t row_of(std::uint32_t kind1, std::uint32_t kind2) const { return walls_ ? kind1 : kind1 * kinds_ + kind2; }
  /// A new row for a contact of two such spheres (the second is not used for a wall), or for its end.
  std::uint32_t open(const Kind& first, const Kind& second);
  void close(std::uint32_t row) { free_.push_back(row); }
  void close_all();

  [[nodiscard]] const ContactLaws* rows() const { return rows_.data(); }
  [[nodiscard]] const double* hold() const { return hold_.data(); }
  [[nodiscard]] const double* bridge() const { return bridges_ ? bridge_.data() : nullptr; }
  [[nodiscard]] double largest_reach() const { return largest_reach_; }  ///< at which something can act beyond touch [m]
  [[nodiscard]] const MappedLaws& mapped() const { return mapped_; }     ///< the first row, with the factors of all
  [[nodiscard]] double radius_share() const { return radius_share_; }    ///< original over scaled radius

 private:
  [[nodiscard]] MappedLaws laws_of(const Kind& first, const Kind& second) const;
  void put(std::uint32_t row, const MappedLaws& laws);

  DemSetup setup_;
  bool walls_ = false, each_ = false, bridges_ = false;
  std::uint32_t kinds_ = 0;
  std::vector<ContactLaws> rows_;
  std::vector<double> hold_, bridge_;
  std::vector<std::uint32_t> free_;
  MappedLaws mapped_;
  double largest_reach_ = 0, radius_share_ = 1;
};

[[nodiscard]] inline LawRows::Kind kind_of(const Spheres& spheres, const std::vector<std::uint8_t>& material_by_id, std::uint32_t sphere) {
  return {spheres.position[sphere].w, material_by_id[spheres.id[sphere]]};
}

/// Distances beyond touch at which a contact of solids tears, and a bridge ruptures, of the scaled pair [m].
[[nodiscard]] double hold_of(const MappedLaws& laws);
[[nodiscard]] double bridge_of(const MappedLaws& laws);

}  // namespace scalebreak::dem
