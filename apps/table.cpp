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

/// Mean time of a lookup [ns], over scattered words of 32 bits; `find` gives a number of what it found, 0 for nothing.
template <class Find>
double lookup_nanoseconds(const Find& find) {
  constexpr int count = 1'000'000;
  unsigned random = 1;
  double sum = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < count; ++i) {
    random = random * 1664525u + 1013904223u;
    sum += find(random);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return sum > 0 ? seconds / count * 1e9 : 0;
}

/// A speed above `slowest` of such a word.
double scattered_speed(double slowest, unsigned random) { return slowest + 1e-5 * (random >> 8); }

/// What a table of any sort says of itself.
template <class Stored>
json table_json(const Stored& stored, std::size_t entries, double lookup_ns) {
  return {{"kind", to_string(stored.table.key().kind)},
          {"tolerance", stored.table.key().tolerance},
          {"entries", entries},
          {"error_max", stored.table.quality().error_max},
          {"error_rms", stored.table.quality().error_rms},
          {"built", stored.built},
          {"build_seconds", stored.build_seconds},
          {"lookup_ns", lookup_ns}};
}

json normal_json(const StoredTable& stored) {
  const CollisionTable& table = stored.table;
  const TableRow row = *table.row(0.1);
  json j = table_json(stored, table.nodes().size(), lookup_nanoseconds([&](unsigned random) {
                        const auto found = row.find(scattered_speed(1.5, random));
                        return found ? found->contact_time : 0;
                      }));
  j["sticking_speed_error"] = table.quality().sticking_speed_error, j["max_overlap_error"] = table.quality().max_overlap_error;
  return j;
}

/// Of an oblique or a rolling table.
template <class Stored>
json surface_json(const Stored& stored, const std::string& surface, double sticking_squared) {
  const auto& table = stored.table;
  const double slowest = 1.2 * std::sqrt(sticking_squared) + 1;
  json j = table_json(stored, table.entries().values().size(), lookup_nanoseconds([&](unsigned random) {
                        return table.find(scattered_speed(slowest, random), 1e-4 * (random & 0xffff)) ? 1.0 : 0.0;
                      }));
  j["surface"] = surface, j["cells"] = table.entries().cells(), j["bytes"] = table.bytes();
  return j;
}

/// The pair's own table of oblique collisions, if the input has friction: beside the table of its normal collisions.
json oblique_result(const Options& options, const Input& input) {
  const auto [key, reason] = oblique_key(input, oblique_tolerance);
  if (!key) {
    options.say("no oblique table: " + reason);
    return nullptr;
  }
  const StoredObliqueTable stored = obtain_oblique_table(*key, options.store(), options.rebuild);
  json j = surface_json(stored, to_string(key->surface), stored.table.sticking_squared());
  j["turning_error_median"] = stored.table.quality().turning_error_median;
  return j;
}

/// And of its rolling, if the input resists that.
json rolling_result(const Options& options, const Input& input) {
  const auto [key, reason] = rolling_key(input, oblique_tolerance);
  if (!key) {
    options.say("no rolling table: " + reason);
    return nullptr;
  }
  const StoredRollingTable stored = obtain_rolling_table(*key, options.store(), options.rebuild);
  return surface_json(stored, std::string("rolling ") + to_string(key->model), stored.table.plane().sticking_squared);
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

/// `what` the table is of; that of head-on collisions has no surface.
void print(const std::string& what, const json& j) {
  const bool normal = !j.contains("surface");
  const std::string name = normal ? j["kind"].get<std::string>() : fmt::format("{}, {}", what, j["surface"].get<std::string>());
  const std::string size =
      normal ? "" : fmt::format(" in {} cells, {:.1f} MiB", j["cells"].get<std::size_t>(), j["bytes"].get<double>() / 1048576);
  const std::string made =
      j["built"].get<bool>() ? fmt::format("built in {:.{}f} s", j["build_seconds"].get<double>(), normal ? 2 : 1) : "read from the cache";
  fmt::print("{}: {} entries{}, largest error {:.2e} (asked {:g}), rms {:.2e}, {}, {:.{}f} ns a lookup\n", name,
             j["entries"].get<std::size_t>(), size, j["error_max"].get<double>(), j["tolerance"].get<double>(),
             j["error_rms"].get<double>(), made, j["lookup_ns"].get<double>(), normal ? 1 : 0);
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
        results.push_back(normal_json(stored));
        if (!options.json) print("", results.back());
        if (!options.out.empty()) write_files(options, stored.table);
      }
      if (!options.all_kinds && input.surface.tangential != TangentialModel::none) {
        json& oblique = results.front()["oblique"] = oblique_result(options, input);
        if (!options.json && !oblique.is_null()) print("oblique", oblique);
      }
      if (!options.all_kinds && input.surface.rolling != RollingModel::none) {
        json& rolling = results.front()["rolling"] = rolling_result(options, input);
        if (!options.json && !rolling.is_null()) print("rolling", rolling);
      }
      deliver(options, input, "table", options.all_kinds ? json{{"tables", results}} : results.front());
    };
  });
}

}  // namespace scalebreak::apps
