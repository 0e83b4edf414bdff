#include <scalebreak/scene/given.hpp>

#include <algorithm>

namespace scalebreak {

const Assignment* find_given(const Given& given, const std::string& key) {
  const auto at = std::find_if(given.begin(), given.end(), [&](const Assignment& item) { return item.key == key; });
  return at == given.end() ? nullptr : &*at;
}

std::string place(const Given& given, const std::vector<std::string>& blame) {
  for (const std::string& key : blame) {
    if (const Assignment* item = find_given(given, key)) return item->where.text + ": ";
  }
  return "";
}

}  // namespace scalebreak
