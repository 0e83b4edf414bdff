#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <scalebreak/output/plot.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// One number of a case; none where it does not exist.
struct CaseNumber {
  std::string name, unit;
  std::optional<double> value;
};

/// One curve, or one system, with its numbers.
struct CaseCurve {
  std::string name;
  std::vector<CaseNumber> numbers;
};

/// What a paper says of a case, as a number that is to be met.
struct CaseBar {
  std::string statement;
  double value;
  double bar;
  bool at_most = true;  ///< else at least

  [[nodiscard]] bool holds() const { return at_most ? value <= bar : value >= bar; }
};

struct CaseFile {
  std::string name, text;
};

struct CasePlot {
  Plot plot;
  std::string caption;
};

/// What became of a case, to be shown or written.
struct CaseResult {
  std::vector<CaseCurve> curves;
  std::vector<CaseBar> bars;
  std::vector<std::string> notes;  ///< what was found, assumed or left out, a sentence each
  std::vector<CaseFile> files;     ///< CSV
  std::vector<CasePlot> plots;
};

/// A named case of a paper: data/papers/NAME.toml is its input.
struct PaperCase {
  std::string name, title, source;
  double seconds;      ///< about how long it takes
  std::size_t bodies;  ///< it is about so many [[body]]; 0: about a pair
  std::function<CaseResult(const Input&, const std::function<void(double)>& progress)> run;
};

/// All cases, in the order of the list.
[[nodiscard]] const std::vector<PaperCase>& paper_cases();
/// Throws InputError that names the cases there are.
[[nodiscard]] const PaperCase& find_paper_case(const std::string& name);
/// The case's input file; throws InputError if the data folder lacks it.
[[nodiscard]] std::filesystem::path paper_case_file(const PaperCase& paper_case);
/// Throws InputError where an input, changed by hand, cannot be that case any more.
void check_paper_case(const PaperCase& paper_case, const Input& input);

/// Writes the files, the plots and index.html into `folder`. False if a plot could not be drawn.
bool write_paper_case(const PaperCase& paper_case, const CaseResult& result, const std::filesystem::path& folder);

// The families, each in a file of its own.
[[nodiscard]] CaseResult run_three_particles(const Input& input, const std::function<void(double)>& progress);
[[nodiscard]] CaseResult run_head_on(const Input& input, const std::function<void(double)>& progress);
[[nodiscard]] CaseResult run_oblique(const Input& input, const std::function<void(double)>& progress);
[[nodiscard]] CaseResult run_impact_speeds(const Input& input, const std::function<void(double)>& progress);
[[nodiscard]] CaseResult run_gap_row(const Input& input, const std::function<void(double)>& progress);

/// A system of a case: the original, or a law at a factor.
struct CaseSystem {
  const ScalingLaw* law;
  double factor;

  [[nodiscard]] bool original() const { return factor == 1; }
  /// "original", or "rps, 0.01".
  [[nodiscard]] std::string name() const;
};

/// The original, then the laws of [study] at each of the factors on their side of 1.
[[nodiscard]] std::vector<CaseSystem> case_systems(const Input& input);

}  // namespace scalebreak
