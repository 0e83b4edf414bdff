#include <scalebreak/ensembles/engine/hybrid_engine.hpp>

#include <algorithm>
#include <numeric>

#include <scalebreak/base/bytes.hpp>

namespace scalebreak {
namespace {

/// Of the spheres: in patches where the flow is handed over, in clusters of three or more where it is taken back (in patches are 2.5 times as many).
constexpr double crowded_share = 0.4, thin_share = 0.08;
/// Looks at the share of patches between two samples, so that a flow that jams does not do so in patches.
constexpr int looks = 8;
/// A flight of fewer samples was too short to be worth it; the longest that soft spheres then stay.
constexpr long short_flight = 8, longest_stay = 1024;

/// Of the spheres, those that touch each other in threes or more, or stay at a wall.
double crowded_part(const System& system) {
  std::vector<std::uint32_t> root(system.count()), size(system.count(), 1);
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](std::uint32_t k) {
    while (root[k] != k) k = root[k] = root[root[k]];
    return k;
  };
  for (const ContactMemory& contact : system.contacts) {
    if (contact.second < 0) continue;
    const std::uint32_t a = find(static_cast<std::uint32_t>(contact.first)), b = find(static_cast<std::uint32_t>(contact.second));
    if (a == b) continue;
    root[b] = a, size[a] += size[b];
  }
  double crowded = 0;
  for (std::uint32_t k = 0; k < root.size(); ++k) crowded += size[find(k)] > 2 ? 1 : 0;
  return crowded / static_cast<double>(system.count());
}

template <class T>
void add(std::optional<T>& to, const std::optional<T>& more) {
  if (more) to = to ? T(*to + *more) : *more;
}

EngineTotals sum(EngineTotals a, const EngineTotals& b) {
  a.contact_starts += b.contact_starts, a.wall_work += b.wall_work, a.steps += b.steps, a.handovers += b.handovers;
  a.evaluations += b.evaluations;
  add(a.contact_time, b.contact_time), add(a.contact_moment, b.contact_moment);
  add(a.events, b.events), add(a.integrated, b.integrated), add(a.delayed, b.delayed);
  if (!b.patches) return a;
  if (!a.patches) a.patches.emplace();
  PatchTotals::pair_up(*a.patches, *b.patches, [](auto& one, const auto& other) { one += other; });
  return a;
}

/// What `sum` adds up, the same list for saving and loading; there are always patches.
template <class Number>
void go_through(EngineTotals& totals, Number&& number) {
  number(totals.contact_starts), number(totals.wall_work), number(totals.steps), number(totals.handovers), number(totals.contact_time);
  number(totals.evaluations);
  if (!totals.contact_moment) totals.contact_moment = Eigen::Matrix3d::Zero();
  for (double& entry : totals.contact_moment->reshaped()) number(entry);
  number(totals.events), number(totals.integrated), number(totals.delayed);
  if (!totals.patches) totals.patches.emplace();
  PatchTotals::pair_up(*totals.patches, *totals.patches, [&](auto& one, const auto&) { number(one); });
}

}  // namespace

HybridEngine::HybridEngine(const System& start, const Input& input, const TableStore& store, const DemSetup& setup)
    : input_(input),
      store_(store),
      setup_(setup),
      count_(start.count()),
      flying_(std::make_unique<EventEngine>(start, input, store, setup)) {}

HybridEngine::HybridEngine(std::string_view saved, const Input& input, const TableStore& store, const DemSetup& setup)
    : input_(input), store_(store), setup_(setup) {
  bool soft = false;
  take_bytes(saved, count_), take_bytes(saved, keeps_sums_), take_bytes(saved, patch_time_), take_bytes(saved, soft);
  take_bytes(saved, since_handover_), take_bytes(saved, stay_), take_bytes(saved, soft_since_);
  go_through(before_, [&](auto& value) { take_bytes(saved, value); });
  if (soft) {
    soft_ = std::make_unique<DemEngine>(saved, setup_, true);
    soft_->keep_sums(keeps_sums_);
  } else {
    flying_ = std::make_unique<EventEngine>(saved, input_, store_, setup_);
  }
}

std::string HybridEngine::save() const {
  std::string bytes;
  put_bytes(bytes, count_), put_bytes(bytes, keeps_sums_), put_bytes(bytes, patch_time_), put_bytes(bytes, soft_ != nullptr);
  put_bytes(bytes, since_handover_), put_bytes(bytes, stay_), put_bytes(bytes, soft_since_);
  EngineTotals before = before_;
  go_through(before, [&](const auto& value) { put_bytes(bytes, value); });
  return bytes + engine().save();
}

double HybridEngine::time() const { return engine().time(); }

void HybridEngine::keep_sums(bool keep) {
  keeps_sums_ = keep;
  if (soft_) soft_->keep_sums(keep);
}

bool HybridEngine::is_crowded(double since) const {
  const double share = (flying_->totals().patches->sphere_time - patch_time_) / (static_cast<double>(count_) * (time() - since));
  return share > crowded_share;
}

bool HybridEngine::is_thin() const { return crowded_part(soft_->system()) < thin_share; }

EngineTotals HybridEngine::running_totals() const {
  EngineTotals totals = engine().totals();
  if (!soft_) return totals;
  totals.patches.emplace();
  totals.patches->contact_starts = totals.contact_starts;
  totals.patches->sphere_time = static_cast<double>(count_) * (soft_->time() - soft_since_);
  return totals;
}

void HybridEngine::hand_over() {
  const System state = flying_->soft_system();
  before_ = sum(before_, flying_->totals());
  ++before_.handovers;
  stay_ = since_handover_ < short_flight ? std::min(2 * stay_, longest_stay) : 1;
  since_handover_ = 0;
  flying_.reset();
  soft_ = std::make_unique<DemEngine>(state, setup_, true);
  soft_->keep_sums(keeps_sums_);
  soft_since_ = soft_->time();
}

void HybridEngine::take_back() {
  const System state = soft_->system();
  before_ = sum(before_, running_totals());
  ++before_.handovers;
  since_handover_ = 0;
  soft_.reset();
  flying_ = std::make_unique<EventEngine>(state, input_, store_, setup_);
  patch_time_ = 0;
}

void HybridEngine::advance_to(double time) {
  const double start = this->time();
  ++since_handover_;
  for (int look = 1; look <= looks; ++look) {
    const double since = this->time();
    if (soft_) {
      soft_->advance_to(time);
      if (since_handover_ >= stay_ && is_thin()) take_back();
      return;
    }
    flying_->advance_to(look < looks ? start + (time - start) * look / looks : time);
    if (this->time() > since && is_crowded(since)) {
      hand_over();
    } else {
      patch_time_ = flying_->totals().patches->sphere_time;
    }
  }
}

EngineTotals HybridEngine::totals() const {
  EngineTotals totals = sum(before_, running_totals());
  // Of what the soft-sphere engine did it is not known.
  totals.dissipated = totals.handovers == 0 ? engine().totals().dissipated : std::nullopt;
  return totals;
}

}  // namespace scalebreak
