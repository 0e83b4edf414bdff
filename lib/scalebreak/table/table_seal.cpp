#include <scalebreak/table/table_seal.hpp>

#include <fmt/format.h>

#include <scalebreak/table/npy.hpp>

namespace scalebreak {
namespace {

std::uint32_t checksum(const nlohmann::json& said, std::vector<std::string_view> texts) {
  const std::string body = said.dump();
  texts.push_back(body);
  return crc32(texts);
}

}  // namespace

void seal(nlohmann::json& said, std::vector<std::string_view> arrays) { said["checksum"] = checksum(said, std::move(arrays)); }

nlohmann::json unsealed(const std::string& text, std::vector<std::string_view> arrays, int format_version, const nlohmann::json& key) {
  nlohmann::json said = nlohmann::json::parse(text);
  const nlohmann::json expected = said.at("checksum");
  said.erase("checksum");
  if (said.at("format_version") != format_version)
    throw fmt::format("it has format version {}, this program has {}", said.at("format_version").dump(), format_version);
  if (said.at("key") != key) throw std::string("it is of another key");
  if (expected != checksum(said, std::move(arrays))) throw std::string("its checksum does not fit");
  return said;
}

}  // namespace scalebreak
