#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace scalebreak {

/// Sums over successive stretches of a run, of as many intervals each. When there are `capacity` of them, neighbours are merged: memory
/// stays bounded, and 128 to 255 blocks resolve the correlation of the rest.
class BlockSeries {
 public:
  static constexpr std::size_t capacity = 256;

  /// The sums of one interval, always of the same length; WorkError otherwise.
  void add(const Eigen::ArrayXd& interval);
  /// In order of time; the last may be shorter. Together they hold everything that was added.
  [[nodiscard]] std::vector<Eigen::ArrayXd> blocks() const;
  [[nodiscard]] std::size_t intervals() const { return intervals_; }

  /// The state, bit for bit, in the bytes of this machine.
  void save(std::string& bytes) const;
  /// Takes its own part off the front. WorkError where it is cut short.
  void load(std::string_view& bytes);

 private:
  std::vector<Eigen::ArrayXd> full_;
  Eigen::ArrayXd open_;
  std::size_t intervals_ = 0, in_block_ = 1, in_open_ = 0;
};

}  // namespace scalebreak
