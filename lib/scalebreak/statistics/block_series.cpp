#include <scalebreak/statistics/block_series.hpp>

#include <utility>

#include <fmt/format.h>

#include <scalebreak/base/bytes.hpp>
#include <scalebreak/base/error.hpp>

namespace scalebreak {

void BlockSeries::add(const Eigen::ArrayXd& interval) {
  if (intervals_ == 0) open_ = Eigen::ArrayXd::Zero(interval.size());
  if (interval.size() != open_.size()) {
    throw WorkError(fmt::format("a measurement of {} sums was continued with {} sums", open_.size(), interval.size()));
  }
  open_ += interval;
  ++intervals_;
  if (++in_open_ < in_block_) return;
  full_.push_back(open_);
  open_.setZero();
  in_open_ = 0;
  if (full_.size() < capacity) return;
  for (std::size_t i = 0; i < capacity / 2; ++i) full_[i] = full_[2 * i] + full_[2 * i + 1];
  full_.resize(capacity / 2);
  in_block_ *= 2;
}

std::vector<Eigen::ArrayXd> BlockSeries::blocks() const {
  std::vector<Eigen::ArrayXd> all = full_;
  if (in_open_ > 0) all.push_back(open_);
  return all;
}

void BlockSeries::save(std::string& bytes) const {
  for (const std::size_t number : {intervals_, in_block_, in_open_, full_.size()}) put_bytes(bytes, number);
  put_bytes(bytes, open_);
  for (const Eigen::ArrayXd& block : full_) put_bytes(bytes, block);
}

void BlockSeries::load(std::string_view& bytes) {
  std::size_t blocks = 0;
  for (std::size_t* number : {&intervals_, &in_block_, &in_open_, &blocks}) take_bytes(bytes, *number);
  if (blocks >= capacity) throw WorkError(fmt::format("a saved measurement has {} blocks; fewer than {} are allowed", blocks, capacity));
  take_bytes(bytes, open_);
  full_.resize(blocks);
  for (Eigen::ArrayXd& block : full_) take_bytes(bytes, block);
}

}  // namespace scalebreak
