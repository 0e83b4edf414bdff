#include <scalebreak/ensembles/run/run_files.hpp>

#include <fmt/format.h>

#include <scalebreak/base/bytes.hpp>
#include <scalebreak/base/error.hpp>
#include <scalebreak/measure/flow_csv.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/particle_files/extended_xyz.hpp>
#include <scalebreak/particle_files/lammps_dump.hpp>
#include <scalebreak/particle_files/particle_csv.hpp>
#include <scalebreak/particle_files/vtp.hpp>

namespace scalebreak {
namespace {

constexpr const char* series = "series.csv";
constexpr const char* extended_xyz_file = "particles.xyz";
constexpr const char* dump_file = "particles.dump";

std::string frame_name(std::size_t frame, const char* ending) { return fmt::format("particles_{:06d}.{}", frame, ending); }

void cut_back(const std::filesystem::path& path, std::uint64_t length) {
  std::error_code failed;
  const std::uint64_t found = std::filesystem::file_size(path, failed);
  if (failed || found < length)
    throw WorkError(fmt::format("{} is {}, and had {} bytes at the checkpoint, so the run cannot go on with it", path.string(),
                                failed ? "gone" : fmt::format("{} bytes long", found), length));
  std::filesystem::resize_file(path, length, failed);
  if (failed) throw WorkError(fmt::format("cannot cut {} back to the checkpoint: {}", path.string(), failed.message()));
}

}  // namespace

RunFiles::RunFiles(std::filesystem::path folder, const OutputInput& output) : folder_(std::move(folder)), output_(output) {
  const std::string header = Csv(series_header()).text();
  write_file(folder_ / series, header);
  lengths_[series] = header.size();
  for (const ParticleFormat format : output_.formats) {
    if (format != ParticleFormat::xyz && format != ParticleFormat::dump) continue;
    const char* name = format == ParticleFormat::xyz ? extended_xyz_file : dump_file;
    write_file(folder_ / name, "");
    lengths_[name] = 0;
  }
}

RunFiles::RunFiles(std::filesystem::path folder, const OutputInput& output, std::string_view saved)
    : folder_(std::move(folder)), output_(output) {
  std::uint64_t count = 0;
  take_bytes(saved, count);
  for (std::uint64_t k = 0; k < count; ++k) {
    const std::string name = take_text(saved);
    take_bytes(saved, lengths_[name]);
  }
  take_bytes(saved, count);
  for (std::uint64_t k = 0; k < count; ++k) take_bytes(saved, frames_.emplace_back());
  for (const auto& [name, length] : lengths_) cut_back(folder_ / name, length);
}

void RunFiles::append(const std::string& name, const std::string& text) {
  append_file(folder_ / name, text);
  lengths_[name] += text.size();
}

void RunFiles::add(const FlowInstant& instant) {
  Csv csv(series_header());
  const std::size_t header = csv.text().size();
  csv.add(series_row(instant.sample(), FlowRun::slabs));
  append(series, csv.text().substr(header));
  for (const ParticleFormat format : output_.formats) add_frame(instant, format);
  frames_.push_back(instant.system.time);
}

void RunFiles::add_frame(const FlowInstant& instant, ParticleFormat format) {
  const System& system = instant.system;
  switch (format) {
    case ParticleFormat::csv: write_file(folder_ / frame_name(frames_.size(), "csv"), particles_csv(system, output_.fields)); break;
    case ParticleFormat::xyz: append(extended_xyz_file, extended_xyz(system, output_.fields)); break;
    case ParticleFormat::dump:
      append(dump_file, lammps_dump(system, static_cast<std::uint64_t>(instant.totals.steps), output_.fields));
      break;
    case ParticleFormat::vtp: {
      write_file(folder_ / frame_name(frames_.size(), "vtp"), spheres_vtp(system, output_.fields));
      std::vector<std::pair<double, std::string>> list;
      for (const double time : frames_) list.emplace_back(time, frame_name(list.size(), "vtp"));
      list.emplace_back(system.time, frame_name(list.size(), "vtp"));
      write_file(folder_ / "particles.pvd", pvd(list));
    }
  }
}

std::string RunFiles::save() const {
  std::string bytes;
  put_bytes(bytes, static_cast<std::uint64_t>(lengths_.size()));
  for (const auto& [name, length] : lengths_) {
    put_text(bytes, name);
    put_bytes(bytes, length);
  }
  put_bytes(bytes, static_cast<std::uint64_t>(frames_.size()));
  for (const double time : frames_) put_bytes(bytes, time);
  return bytes;
}

}  // namespace scalebreak
