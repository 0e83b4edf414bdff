#include <scalebreak/table/npy.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <boost/crc.hpp>

namespace scalebreak {

std::string npy_header(const std::string& type, const std::vector<std::size_t>& shape) {
  std::string dict =
      fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': ({}{}), }}", type, fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
  while ((10 + dict.size() + 1) % 64 != 0) dict += ' ';
  dict += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(dict.size() & 0xff);
  header += static_cast<char>(dict.size() >> 8);
  return header + dict;
}

std::uint32_t crc32(const std::vector<std::string_view>& texts) {
  boost::crc_32_type crc;
  for (const std::string_view text : texts) crc.process_bytes(text.data(), text.size());
  return crc.checksum();
}

}  // namespace scalebreak
