#include <scalebreak/ensembles/run/checkpoint.hpp>

#include <fmt/format.h>

#include <scalebreak/base/bytes.hpp>
#include <scalebreak/base/error.hpp>
#include <scalebreak/base/version.hpp>
#include <scalebreak/output/atomic_file.hpp>

namespace scalebreak {
namespace {

constexpr std::string_view magic = "scalebreak checkpoint\n";

}  // namespace

std::filesystem::path checkpoint_path(const std::filesystem::path& folder) { return folder / "checkpoint.bin"; }

void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint) {
  std::string bytes(magic);
  put_text(bytes, checkpoint.version);
  put_text(bytes, checkpoint.input);
  put_text(bytes, checkpoint.engine);
  put_bytes(bytes, checkpoint.threads);
  put_bytes(bytes, checkpoint.wall_seconds);
  put_bytes(bytes, checkpoint.time);
  put_bytes(bytes, static_cast<std::uint64_t>(checkpoint.finished.size()));
  for (const std::string& replica : checkpoint.finished) put_text(bytes, replica);
  put_text(bytes, checkpoint.run);
  put_text(bytes, checkpoint.files);
  write_file(checkpoint_path(folder), bytes);
}

Checkpoint read_checkpoint(const std::filesystem::path& folder) {
  const std::filesystem::path path = checkpoint_path(folder);
  const std::optional<std::string> content = read_file(path);
  if (!content && std::filesystem::exists(folder / "result.json"))
    throw InputError(fmt::format("--resume: the run in {} is finished; allowed: the folder of an unfinished one", folder.string()));
  if (!content)
    throw InputError(
        fmt::format("--resume: {} holds no checkpoint.bin; allowed: --out with the folder of an unfinished run", folder.string()));
  std::string_view bytes = *content;
  if (!bytes.starts_with(magic)) throw InputError(fmt::format("--resume: {} is no checkpoint; allowed: one that run wrote", path.string()));
  bytes.remove_prefix(magic.size());
  Checkpoint checkpoint;
  checkpoint.version = take_text(bytes);
  if (checkpoint.version != version())
    throw InputError(fmt::format("--resume: {} is of scalebreak {}, and this is {}; allowed: the same version", path.string(),
                                 checkpoint.version, version()));
  checkpoint.input = take_text(bytes);
  checkpoint.engine = take_text(bytes);
  take_bytes(bytes, checkpoint.threads);
  take_bytes(bytes, checkpoint.wall_seconds);
  take_bytes(bytes, checkpoint.time);
  std::uint64_t count = 0;
  take_bytes(bytes, count);
  for (std::uint64_t k = 0; k < count; ++k) checkpoint.finished.push_back(take_text(bytes));
  checkpoint.run = take_text(bytes);
  checkpoint.files = take_text(bytes);
  return checkpoint;
}

void remove_checkpoint(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::remove(checkpoint_path(folder), failed);
  if (failed) throw WorkError(fmt::format("cannot remove {}: {}", checkpoint_path(folder).string(), failed.message()));
}

}  // namespace scalebreak
