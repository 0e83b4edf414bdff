#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/papers/paper_case.hpp>

#include "command.hpp"

namespace scalebreak::apps {
namespace {

using nlohmann::json;

json result_json(const PaperCase& paper_case, const CaseResult& result) {
  json curves = json::array(), bars = json::array();
  for (const CaseCurve& curve : result.curves) {
    json entry = {{"curve", curve.name}};
    for (const CaseNumber& number : curve.numbers) entry[number.name] = or_null(number.value);
    curves.push_back(entry);
  }
  for (const CaseBar& bar : result.bars)
    bars.push_back({{"statement", bar.statement},
                    {"value", bar.value},
                    {"bar", bar.bar},
                    {"sense", bar.at_most ? "at most" : "at least"},
                    {"holds", bar.holds()}});
  return {{"case", paper_case.name}, {"title", paper_case.title}, {"source", paper_case.source}, {"curves", curves}, {"bars", bars},
          {"notes", result.notes}};
}

void print(const PaperCase& paper_case, const CaseResult& result) {
  fmt::print("{}: {}\n{}\n", paper_case.name, paper_case.title, paper_case.source);
  for (const CaseCurve& curve : result.curves) {
    fmt::print("{}:", curve.name);
    const char* separator = " ";
    for (const CaseNumber& number : curve.numbers) {
      fmt::print("{}{} {}{}", separator, number.name, number.value ? fmt::format("{:.5g}", *number.value) : "-",
                 number.unit == "-" ? "" : " " + number.unit);
      separator = ", ";
    }
    fmt::print("\n");
  }
  for (const CaseBar& bar : result.bars)
    fmt::print("{}: {:.3g}, {} {:g}: {}\n", bar.statement, bar.value, bar.at_most ? "at most" : "at least", bar.bar,
               bar.holds() ? "holds" : "DOES NOT HOLD");
  for (const std::string& note : result.notes) fmt::print("{}\n", note);
}

void list(const Options& options) {
  json cases = json::array();
  for (const PaperCase& c : paper_cases()) {
    cases.push_back({{"name", c.name}, {"title", c.title}, {"source", c.source}});
    if (!options.json) fmt::print("{:<10} {} ({})\n", c.name, c.title, c.source);
  }
  if (options.json) fmt::print("{}\n", json{{"cases", cases}}.dump());
}

void run(const Options& given) {
  if (given.files.empty() && !given.print_defaults)
    throw InputError("reproduce: the name of a case is missing; allowed: one of those that reproduce --list prints");
  Options options = given;
  if (given.print_defaults) return void(answered_early(options, {}));
  const PaperCase& paper_case = find_paper_case(given.files.front());
  options.files = {given.files.size() > 1 ? given.files[1] : paper_case_file(paper_case).string()};
  const Input input = options.input();
  check_paper_case(paper_case, input);
  if (answered_early(options, [&](const Input&) { return fmt::format("about {:g} s, below 100 MB", paper_case.seconds); })) return;
  const CaseResult result = paper_case.run(input, options.progress(paper_case.name));
  if (!options.out.empty() && !write_paper_case(paper_case, result, options.out))
    options.say("some plots were not drawn: gnuplot is missing or failed; their scripts are kept in " + options.out);
  deliver(options, input, "reproduce " + paper_case.name, result_json(paper_case, result));
  if (!options.json) print(paper_case, result);
}

}  // namespace

void add_reproduce(CLI::App& app, Options& options, std::function<void()>& job) {
  CLI::App* command = app.add_subcommand("reproduce", "a named case of the papers: its curves, and its numbers beside what the paper says");
  add_options(*command, options, 2);
  command->get_option("file")
      ->description("the case (--list names them all), and an input in place of its own, data/papers/NAME.toml")
      ->type_name("NAME [FILE.toml]");
  command->add_flag("--list", options.list, "print the cases, then stop");
  command->callback([&] { job = [&options] { options.list ? list(options) : run(options); }; });
}

}  // namespace scalebreak::apps
