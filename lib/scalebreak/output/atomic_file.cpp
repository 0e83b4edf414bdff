#include <iterator>
#include <scalebreak/output/atomic_file.hpp>

#include <cerrno>
#include <cstring>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace fs = std::filesystem;
namespace {

void make_folder_of(const fs::path& path) {
  std::error_code failed;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), failed);
  if (failed) throw WorkError(fmt::format("cannot make the folder {}: {}", path.parent_path().string(), failed.message()));
}

}  // namespace

void write_file(const fs::path& path, std::string_view content) {
  make_folder_of(path);
  std::error_code failed;
  const fs::path part = path.string() + fmt::format(".{}.part", ::getpid());
  {
    std::ofstream file(part, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file) {
      const std::string reason = std::strerror(errno);
      fs::remove(part, failed);
      throw WorkError(fmt::format("cannot write {}: {}", path.string(), reason));
    }
  }
  fs::rename(part, path, failed);
  if (failed) {
    const std::string reason = failed.message();
    fs::remove(part, failed);
    throw WorkError(fmt::format("cannot put {} in place: {}", path.string(), reason));
  }
}

void append_file(const fs::path& path, std::string_view content) {
  make_folder_of(path);
  std::error_code failed;
  const bool existed = fs::exists(path, failed);
  const auto length = existed ? fs::file_size(path, failed) : 0;
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::app);
  const bool opened = file.is_open();
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (file) return;
  const std::string reason = std::strerror(errno);
  if (opened && existed) fs::resize_file(path, length, failed);
  if (opened && !existed) fs::remove(path, failed);
  throw WorkError(fmt::format("cannot append to {}: {}", path.string(), reason));
}

std::optional<std::string> read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace scalebreak
