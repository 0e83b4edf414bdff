#include <scalebreak/base/version.hpp>

namespace scalebreak {

std::string_view version() {
  return
#include "version.inc"
      ;
}

}  // namespace scalebreak
