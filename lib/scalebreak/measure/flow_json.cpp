#include <scalebreak/measure/flow_json.hpp>

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/measure/sums/evaluate_flow.hpp>

namespace scalebreak {
namespace {

nlohmann::json number(double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr); }

nlohmann::json rows(const Eigen::Matrix3d& tensor) {
  nlohmann::json result;
  for (const Eigen::Index i : {0, 1, 2}) result.push_back({number(tensor(i, 0)), number(tensor(i, 1)), number(tensor(i, 2))});
  return result;
}

double read_number(const nlohmann::json& value, const std::string& name) {
  if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (!value.is_number()) throw WorkError(fmt::format("a result's {} is {}; a number or null is expected", name, value.dump()));
  return value.get<double>();
}

Eigen::Matrix3d read_rows(const nlohmann::json& value, const std::string& name) {
  const auto three = [](const nlohmann::json& list) { return list.is_array() && list.size() == 3; };
  if (!three(value) || !three(value[0]) || !three(value[1]) || !three(value[2])) {
    throw WorkError(fmt::format("a result's {} is {}; three rows of three numbers are expected", name, value.dump()));
  }
  Eigen::Matrix3d result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result(static_cast<int>(i), static_cast<int>(j)) = read_number(value[i][j], name);
  }
  return result;
}

void append(std::vector<Quantity>& quantities, const std::string& name, const MeasuredTensor& tensor) {
  for (const Eigen::Index i : {0, 1, 2}) {
    for (const Eigen::Index j : {0, 1, 2}) {
      quantities.push_back({name + "_" + tensor_entry_name(i, j), "Pa", {tensor.value(i, j), tensor.error(i, j)}});
    }
  }
}

}  // namespace

nlohmann::json flow_json(const FlowResult& result) {
  nlohmann::json json;
  json["measured_time"] = result.duration;
  json["outside"] = result.outside;
  for (const Quantity& quantity : result.quantities) {
    json[quantity.name] = number(quantity.measured.value);
    json[quantity.name + "_error"] = number(quantity.measured.error);
  }
  json["stress"] = rows(result.stress.value);
  json["stress_error"] = rows(result.stress.error);
  json["stress_contact"] = rows(result.stress_contact.value);
  json["stress_contact_error"] = rows(result.stress_contact.error);
  return json;
}

std::vector<Quantity> quantities_of(const nlohmann::json& result) {
  std::vector<Quantity> quantities;
  for (Quantity quantity : evaluate_flow({}, ProfileKind::uniform, 0).quantities) {
    if (!result.contains(quantity.name)) continue;
    quantity.measured.value = read_number(result[quantity.name], quantity.name);
    const std::string error = quantity.name + "_error";
    if (result.contains(error)) quantity.measured.error = read_number(result[error], error);
    quantities.push_back(quantity);
  }
  for (const std::string name : {"stress", "stress_contact"}) {
    if (!result.contains(name) || !result.contains(name + "_error")) continue;
    append(quantities, name, {read_rows(result[name], name), read_rows(result[name + "_error"], name + "_error")});
  }
  return quantities;
}

std::vector<Quantity> all_quantities(const FlowResult& result) {
  std::vector<Quantity> quantities = result.quantities;
  append(quantities, "stress", result.stress);
  append(quantities, "stress_contact", result.stress_contact);
  return quantities;
}

}  // namespace scalebreak
