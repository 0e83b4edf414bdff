#include <scalebreak/dem/group/group_laws.hpp>

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/dem/walls.hpp>

namespace scalebreak {

using namespace dem;

namespace {

Cell open_cell() {
  Cell cell;
  cell.boundary = {Boundary::open, Boundary::open, Boundary::open};
  return cell;
}

}  // namespace

GroupLaws::GroupLaws(const DemSetup& setup, const Cell& cell, std::vector<LawRows::Kind> kinds, bool each)
    : kernel_(setup.kernel ? &kernel(setup.kernel) : &kernel_for_few()),
      kinds_(std::move(kinds)),
      images_(open_cell(), 0),
      gravity_(setup.gravity),
      step_(setup.step) {
  if (kinds_.empty() || kinds_.size() > most_kinds)
    throw InputError(
        fmt::format("particles.size: found spheres of {} radii and materials; allowed: 1 to {} in groups that are integrated on their own",
                    kinds_.size(), most_kinds));
  rows_ = LawRows(setup, kinds_, false, each);
  walls_ = walls_of(cell, setup.wall_no_slip);
  if (!walls_.empty()) wall_rows_ = LawRows(setup, kinds_, true, each);
  const ContactLaws& laws = rows_.mapped().laws;
  turns_ = laws.spins() || (!walls_.empty() && wall_rows_.mapped().laws.spins());
  slides_ = laws.tangential.acts();
  rolls_ = laws.rolling.acts() && !laws.rolling.rigid();
  largest_reach_ = std::max(rows_.largest_reach(), walls_.empty() ? 0.0 : wall_rows_.largest_reach());
}

std::uint32_t GroupLaws::kind_number(const LawRows::Kind& kind) const {
  if (each()) return 0;
  const auto at = std::find(kinds_.begin(), kinds_.end(), kind);
  if (at == kinds_.end()) throw std::logic_error("a sphere of a kind that the group's laws do not have");
  return static_cast<std::uint32_t>(at - kinds_.begin());
}

}  // namespace scalebreak
