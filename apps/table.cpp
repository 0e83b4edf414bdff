#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/collisions/tables/oblique_table_builder.hpp>
#include <scalebreak/collisions/tables/rolling_table_builder.hpp>
#include <scalebreak/contact/damping.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/output/plot.hpp>
#include <scalebreak/table/table_file.hpp>

#include "command.hpp"

namespace scalebreak::apps {
namespace {

using nlohmann::json;

/// Of the tangential and rolling outcomes; the normal ones have numerics.table_tolerance.
constexpr double oblique_tolerance = 1e-4;

/// Mean time of a lookup at one damping ratio [ns], over scattered speeds.
double measure_lookup(const CollisionTable& table) {
  const TableRow row = *table.row(0.1);
  constexpr int count = 1'000'000;
  unsigned random = 1;
  double sum = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < count; ++i) {
    random = random * 1664525u + 1013904223u;
    const auto found = row.find(1.5 + 1e-5 * (random >> 8));
    sum += found ? found->contact_time : 0;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return sum > 0 ? seconds / count * 1e9 : 0;
}

json table_json(const StoredTable& stored) {
  const CollisionTable& table = stored.table;
  return {{"kind", to_string(table.key().kind)},
          {"tolerance", table.key().tolerance},
          {"entries", table.nodes().size()},
          {"error_max", table.quality().error_max},
          {"error_rms", table.quality().error_rms},
          {"sticking_speed_error", table.quality().sticking_speed_error},
          {"max_overlap_error", table.quality().max_overlap_error},
          {"built", stored.built},
          {"build_seconds", stored.build_seconds},
          {"lookup_ns", measure_lookup(table)}};
}

/// Mean time of a lookup of an oblique or a rolling table [ns], over scattered speeds and ratios.
template <class Table>
double measure_scattered_lookup(const Table& table, double sticking_squared) {
  constexpr int count = 1'000'000;
  unsigned random = 1;
  int found = 0;
  const double slowest = 1.2 * std::sqrt(sticking_squared) + 1;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < count; ++i) {
    random = random * 1664525u + 1013904223u;
    found += table.find(slowest + 1e-5 * (random >> 8), 1e-4 * (random & 0xffff)).has_value();
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return found > 0 ? seconds / count * 1e9 : 0;
}

json oblique_json(const StoredObliqueTable& stored) {
  const ObliqueTable& table = stored.table;
  return {{"kind", to_string(table.key().kind)},
          {"surface", to_string(table.key().surface)},
          {"tolerance", table.key().tolerance},
          {"entries", table.entries().values().size()},
          {"cells", table.entries().cells()},
          {"bytes", table.bytes()},
          {"error_max", table.quality().error_max},
          {"error_rms", table.quality().error_rms},
          {"turning_error_median", table.quality().turning_error_median},
          {"built", stored.built},
          {"build_seconds", stored.build_seconds},
          {"lookup_ns", measure_scattered_lookup(table, table.sticking_squared())}};
}

json rolling_json(const StoredRollingTable& stored) {
  const RollingTable& table = stored.table;
  return {{"kind", to_string(table.key().kind)},
          {"surface", std::string("rolling ") + to_string(table.key().model)},
          {"tolerance", table.key().tolerance},
          {"entries", table.entries().values().size()},
          {"cells", table.entries().cells()},
          {"bytes", table.bytes()},
          {"error_max", table.quality().error_max},
          {"error_rms", table.quality().error_rms},
          {"built", stored.built},
          {"build_seconds", stored.build_seconds},
          {"lookup_ns", measure_scattered_lookup(table, table.plane().sticking_squared)}};
}

/// The pair's own table of oblique collisions, if the input has friction: beside the table of its normal collisions.
json oblique_result(const Options& options, const Input& input) {
  const auto [key, reason] = oblique_key(input, oblique_tolerance);
  if (!key) {
    options.say("no oblique table: " + reason);
    return nullptr;
  }
  return oblique_json(obtain_oblique_table(*key, options.store(), options.rebuild));
}

/// And of its rolling, if the input resists that.
json rolling_result(const Options& options, const Input& input) {
  const auto [key, reason] = rolling_key(input, oblique_tolerance);
  if (!key) {
    options.say("no rolling table: " + reason);
    return nullptr;
  }
  return rolling_json(obtain_rolling_table(*key, options.store(), options.rebuild));
}

/// The rows of nine restitutions put in, as a CSV and as plots of the restitution and the contact time that come out.
void write_files(const Options& options, const CollisionTable& table) {
  const std::string name = table_file_name(table.key());
  const std::string csv_name = name + ".csv", kind = to_string(table.key().kind);
  Csv csv({"restitution_given [-]", "speed_reduced [-]", "restitution_normal [-]", "contact_time_reduced [-]", "max_overlap_reduced [-]"});
  Plot restitution{name + "-restitution",
                   "Restitution in the collision table: " + kind,
                   "reduced impact speed [-]",
                   "coefficient of restitution [-]",
                   true,
                   false,
                   {}};
  Plot time{name + "-contact_time",
            "Contact time in the collision table: " + kind,
            "reduced impact speed [-]",
            "reduced contact time [-]",
            true,
            true,
            {}};
  const int rows = table.damping_axis().count, columns = table.speed_axis().count;
  for (int row = 0; row < rows; row += (rows - 1) / 8) {
    const TableNode* nodes = table.nodes().data() + row * columns;
    const double given = restitution_of_damping_ratio(nodes->damping_ratio);
    for (const TableNode* node = nodes; node != nodes + columns; ++node) {
      csv.add({given, node->speed, node->restitution, node->contact_time, node->max_overlap});
    }
    const std::string only = fmt::format("abs($1 - {:.17g}) < 1e-12", given), legend = fmt::format("e put in: {:.3g}", given);
    restitution.curves.push_back({csv_name, "2", "3", legend, false, row * 8 / (rows - 1), only});
    time.curves.push_back({csv_name, "2", "4", legend, false, row * 8 / (rows - 1), only});
  }
  write_file(std::filesystem::path(options.out) / csv_name, csv.text());
  if (columns == 1) return;  // no speed to plot over
  for (const Plot& plot : {restitution, time}) {
    if (!draw(plot, options.out))
      options.say(plot.name + " was not drawn: gnuplot is missing or failed; its script is kept in " + options.out);
  }
}

void print_of_pair(const char* what, const json& j) {
  fmt::print(
      "{}, {}: {} entries in {} cells, {:.1f} MiB, largest error {:.2e} (asked {:g}), rms {:.2e}, {}, {:.0f} ns a lookup\n", what,
      j["surface"].get<std::string>(), j["entries"].get<std::size_t>(), j["cells"].get<std::size_t>(), j["bytes"].get<double>() / 1048576,
      j["error_max"].get<double>(), j["tolerance"].get<double>(), j["error_rms"].get<double>(),
      j["built"].get<bool>() ? fmt::format("built in {:.1f} s", j["build_seconds"].get<double>()) : std::string("read from the cache"),
      j["lookup_ns"].get<double>());
}

void print(const json& j) {
  fmt::print(
      "{}: {} entries, largest error {:.2e} (asked {:g}), rms {:.2e}, {}, {:.1f} ns a lookup\n", j["kind"].get<std::string>(),
      j["entries"].get<std::size_t>(), j["error_max"].get<double>(), j["tolerance"].get<double>(), j["error_rms"].get<double>(),
      j["built"].get<bool>() ? fmt::format("built in {:.2f} s", j["build_seconds"].get<double>()) : std::string("read from the cache"),
      j["lookup_ns"].get<double>());
}

}  // namespace

void add_table(CLI::App& app, Options& options, std::function<void()>& job) {
  CLI::App* command = app.add_subcommand("table", "build or inspect the collision table of a scene's kind of contact");
  add_options(*command, options);
  command->add_flag("--all", options.all_kinds, "the tables of every kind of contact");
  command->add_flag("--rebuild", options.rebuild, "build even where a good table is kept");
  command->callback([&] {
    job = [&options] {
      if (answered_early(options, [](const Input& input) {
            const bool slides = input.surface.tangential != TangentialModel::none, rolls = input.surface.rolling != RollingModel::none;
            return std::string(slides  ? "about 30 s on 2 cores at the default tolerance, below 20 MB"
                               : rolls ? "about 5 s on 2 cores at the default tolerance, below 10 MB"
                                       : "about 1 s on 2 cores at the default tolerance, below 10 MB");
          }))
        return;
      const Input input = options.input();
      const auto kinds =
          options.all_kinds ? all_contact_kinds() : std::vector{effective_kind(input.contact, input.colliding().pair().surface_energy)};
      json results = json::array();
      for (const ContactKind& kind : kinds) {
        const StoredTable stored = obtain_table({kind, input.table_tolerance}, options.store(), options.rebuild);
        results.push_back(table_json(stored));
        if (!options.json) print(results.back());
        if (!options.out.empty()) write_files(options, stored.table);
      }
      if (!options.all_kinds && input.surface.tangential != TangentialModel::none) {
        results.front()["oblique"] = oblique_result(options, input);
        if (!options.json && !results.front()["oblique"].is_null()) print_of_pair("oblique", results.front()["oblique"]);
      }
      if (!options.all_kinds && input.surface.rolling != RollingModel::none) {
        results.front()["rolling"] = rolling_result(options, input);
        if (!options.json && !results.front()["rolling"].is_null()) print_of_pair("rolling", results.front()["rolling"]);
      }
      deliver(options, input, "table", options.all_kinds ? json{{"tables", results}} : results.front());
    };
  });
}

}  // namespace scalebreak::apps
