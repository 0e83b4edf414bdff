#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/dem/engine.hpp>

// The engine's state as bytes: what is written is what lies in memory, so that a run goes on bit for bit.

namespace scalebreak {

using namespace dem;

namespace {

constexpr std::uint64_t format = 0x73626465'6d303033;  // "sbdem003"

/// Appends.
struct Writer {
  std::string bytes;
  template <class T>
  void one(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T, class Memory>
  void list(std::vector<T, Memory>& values) {
    std::uint64_t size = values.size();
    one(size);
    bytes.append(reinterpret_cast<const char*>(values.data()), size * sizeof(T));
  }
};

/// Takes off the front.
struct Reader {
  std::string_view bytes;
  static constexpr const char* broken = "the saved state of the engine is cut short; start from an earlier one";
  template <class T>
  void one(T& value) {
    if (bytes.size() < sizeof value) throw WorkError(broken);
    std::memcpy(static_cast<void*>(&value), bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
  }
  template <class T, class Memory>
  void list(std::vector<T, Memory>& values) {
    std::uint64_t size = 0;
    one(size);
    if (size > bytes.size() / sizeof(T)) throw WorkError(broken);
    values.resize(size);
    if (size > 0) std::memcpy(static_cast<void*>(values.data()), bytes.data(), size * sizeof(T));
    bytes.remove_prefix(size * sizeof(T));
  }
};

template <class Archive>
void put_pairs(Archive& archive, Pairs& pairs) {
  Contacts& contacts = pairs.contacts;
  archive.one(pairs.near_count), archive.list(pairs.near_first), archive.list(pairs.near_second);
  archive.one(contacts.count), archive.one(contacts.sorted), archive.one(contacts.slides), archive.one(contacts.rolls);
  archive.list(contacts.first), archive.list(contacts.second), archive.list(contacts.state), archive.list(contacts.begun);
  archive.list(contacts.row), archive.list(contacts.slide.values()), archive.list(contacts.roll.values());
}

}  // namespace

/// What the rest is laid out by.
template <class Archive>
void Dem::Engine::archive_head(Archive& archive) {
  for (double* value : {&start_time_, &smallest_, &largest_, &volume_fraction_, &flow_rate_, &grid_offset_, &fastest_squared_, &travel_,
                        &travel_of_grid_, &skins_.neighbours, &skins_.near, &cell_.shear_rate, &cell_.shear_offset, &cell_.wall_speed,
                        &height_.pressure, &height_.inertia, &height_.speed, &stretch_, &stretch_rate_})
    archive.one(*value);
  for (const int axis : {0, 1, 2}) archive.one(cell_.size[axis]), archive.one(cell_.boundary[static_cast<std::size_t>(axis)]);
  archive.one(turns_), archive.one(each_), archive.list(kinds_), archive.list(material_);
  archive.one(steps_), archive.one(steps_at_grid_), archive.one(steps_since_lists_), archive.one(keep_sums_);
  for (double* value : {&totals_.contact_starts, &totals_.contact_time, &totals_.wall_work, &totals_.pairs_tested, &totals_.lists_made,
                        &totals_.grids_made})
    archive.one(*value);
  for (int k = 0; k < 9; ++k) archive.one(totals_.contact_moment(k / 3, k % 3));
}

template <class Archive>
void Dem::Engine::archive_body(Archive& archive) {
  archive.list(spheres_.id), archive.list(spheres_.position), archive.list(spheres_.velocity), archive.list(spheres_.spin);
  archive.list(spheres_.force), archive.list(spheres_.torque), archive.list(spheres_.seen_velocity), archive.list(spheres_.seen_spin);
  archive.list(spheres_.kind), archive.list(moves_);
  for (Worker& worker : workers_) {
    archive.one(worker.begin), archive.one(worker.end), archive.one(worker.resting_fastest_squared);
    archive.list(worker.start), archive.list(worker.neighbours), archive.list(worker.movers);
    archive.list(worker.pushed);
    put_pairs(archive, worker.pairs);
    for (WallPairs& wall : worker.walls) put_pairs(archive, wall.pairs);
  }
}

std::string Dem::Engine::save() const {
  Writer writer;
  std::uint64_t magic = format, threads = workers_.size();
  writer.one(magic), writer.one(threads);
  auto& self = const_cast<Engine&>(*this);  // a Writer only reads
  self.archive_head(writer);
  self.archive_body(writer);
  return std::move(writer.bytes);
}

Dem::Engine::Engine(std::string_view saved, const DemSetup& setup) : kernel_(dem::kernel(setup.kernel)), setup_(setup), images_(Cell{}, 0) {
  Reader reader{saved};
  std::uint64_t magic = 0, threads = 0;
  reader.one(magic), reader.one(threads);
  if (magic != format) throw WorkError("the saved state is not one of this engine's, or of another version; start from another one");
  if (threads != static_cast<std::uint64_t>(setup.threads))
    throw InputError(
        fmt::format("the saved state is of {} threads, found {}; allowed: the same number, so that the run goes on bit for bit", threads,
                    setup.threads));
  archive_head(reader);
  make_rows();
  make_workers();
  archive_body(reader);
  images_ = Images(cell_now(), image_offset());
  pushed_.resize(spheres_.count());
  for (Worker& worker : workers_) {
    reopen_rows(worker);
    for (const std::uint32_t sphere : worker.pushed) pushed_[sphere] = 1;
  }
}

}  // namespace scalebreak
