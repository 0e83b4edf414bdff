#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/invariance/invariance.hpp>
#include <scalebreak/collisions/papers/paper_case.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/html.hpp>
#include <scalebreak/scene/materials.hpp>

namespace scalebreak {

const std::vector<PaperCase>& paper_cases() {
  static const std::string washino = "Washino et al., Chem. Eng. Res. Des. 203 (2024) 501, section 4";
  static const std::string chen = "Chen & Elliott, On the scaling law of JKR contact model, Table 4";
  static const std::vector<PaperCase> cases = {
      {"w-case1", "Three spheres in a row: linear contact, liquid, EPSD rolling", washino + ", Tables 5 and 6, Figs 2 and 5", 8, 3,
       run_three_particles},
      {"w-case2", "Three spheres in a row: Hertz contact, liquid, CDT rolling", washino + ", Tables 5 and 7, Figs 3 and 6", 8, 3,
       run_three_particles},
      {"w-case3", "Three spheres in a row: JKR contact, adhesive rolling", washino + ", Tables 5 and 8, Figs 4 and 7", 8, 3,
       run_three_particles},
      {"c-case-a", "Head-on collision of unlike spheres under three size laws", chen + ", case a, Fig. 3", 1, 2, run_head_on},
      {"c-case-b", "Oblique impact of enlarged spheres on a plane", chen + ", case b, Fig. 4", 1, 0, run_oblique},
      {"c-case-c", "Restitution and contact time of latex on quartz, original and enlarged", chen + ", case c, Figs 5 and 6", 1, 0,
       run_impact_speeds},
      {"gap-row", "Where a softened row of three spheres stops colliding two by two",
       "no paper: what Washino et al. 2024 leave open in section 4, where no initial gap is given", 5, 3, run_gap_row},
  };
  return cases;
}

const PaperCase& find_paper_case(const std::string& name) {
  const auto& cases = paper_cases();
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const PaperCase& c) { return c.name == name; });
  if (found != cases.end()) return *found;
  std::vector<std::string> names;
  for (const PaperCase& c : cases) names.push_back(c.name);
  throw InputError(fmt::format("reproduce: found the case \"{}\"; allowed: \"{}\"", name, fmt::join(names, "\", \"")));
}

std::filesystem::path paper_case_file(const PaperCase& paper_case) {
  const std::filesystem::path file = data_folder() / "papers" / (paper_case.name + ".toml");
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed))
    throw InputError(fmt::format("reproduce: the input of \"{}\" is missing, {}; set SCALEBREAK_DATA to the folder that holds papers/",
                                 paper_case.name, file.string()));
  return file;
}

void check_paper_case(const PaperCase& paper_case, const Input& input) {
  if (input.scaling_law != "none" || input.scaling_factor != 1)
    throw InputError(
        fmt::format("reproduce {}: scaling.law = \"{}\" with scaling.factor = {:g} cannot be used, the case compares those of "
                    "study.laws and study.factors; allowed: \"none\" and 1",
                    paper_case.name, input.scaling_law, input.scaling_factor));
  if (input.bodies.size() != paper_case.bodies) {
    throw InputError(fmt::format("reproduce {}: found {} [[body]] tables; allowed: {}", paper_case.name, input.bodies.size(),
                                 paper_case.bodies == 0 ? "none, but [pair] and [impact]" : fmt::format("{}", paper_case.bodies)));
  }
  if (paper_case.bodies == 0) return;
  // All these cases are of free bodies in one line.
  const Eigen::Vector3d line = (input.bodies[1].position - input.bodies[0].position).normalized();
  for (std::size_t i = 0; i < input.bodies.size(); ++i) {
    const Body& body = input.bodies[i];
    const Eigen::Vector3d from_first = body.position - input.bodies[0].position;
    const bool off = (from_first - line * line.dot(from_first)).norm() > 1e-9 * body.radius;
    const bool oblique = (body.velocity - line * line.dot(body.velocity)).norm() > 1e-9 * body.velocity.norm();
    if (off || oblique || body.fixed) {
      throw InputError(fmt::format("reproduce {}: body.{} {}; allowed: free bodies in one line that move along it", paper_case.name, i + 1,
                                   body.fixed ? "is fixed"
                                   : off      ? "is off the line of the first two"
                                              : "moves across the line"));
    }
  }
}

std::string CaseSystem::name() const { return original() ? "original" : fmt::format("{}, {:g}", law->name, factor); }

std::vector<CaseSystem> case_systems(const Input& input) {
  std::vector<CaseSystem> systems = {{find_scaling_law("none"), 1}};
  for (const std::string& name : study_laws(input)) {
    const ScalingLaw* law = find_scaling_law(name);
    for (const double factor : input.study_factors) {
      if (factor != 1 && !refusal(*law, factor, input.contact.normal)) systems.push_back({law, factor});
    }
  }
  return systems;
}

bool write_paper_case(const PaperCase& paper_case, const CaseResult& result, const std::filesystem::path& folder) {
  for (const CaseFile& file : result.files) write_file(folder / file.name, file.text);
  bool drawn = true;
  for (const CasePlot& plot : result.plots) drawn = draw(plot.plot, folder) && drawn;
  HtmlReport report(paper_case.title, paper_case.source + ".");
  for (const std::string& note : result.notes) report.paragraph(note);
  if (!result.bars.empty()) {
    report.heading("What the paper says, and what comes out");
    std::vector<std::vector<std::string>> rows;
    for (const CaseBar& bar : result.bars)
      rows.push_back({bar.statement, fmt::format("{:.3g}", bar.value),
                      fmt::format("{} {:g}", bar.at_most ? "at most" : "at least", bar.bar), bar.holds() ? "yes" : "no"});
    report.table({"statement", "measured", "bar", "holds"}, rows);
  }
  for (const CasePlot& plot : result.plots) report.figure(folder / (plot.plot.name + ".svg"), plot.caption);
  if (!result.curves.empty()) {
    report.heading("Numbers");
    std::vector<std::string> header = {"curve"};
    for (const CaseNumber& number : result.curves.front().numbers) header.push_back(fmt::format("{} [{}]", number.name, number.unit));
    std::vector<std::vector<std::string>> rows;
    for (const CaseCurve& curve : result.curves) {
      rows.push_back({curve.name});
      for (const CaseNumber& number : curve.numbers) rows.back().push_back(number.value ? fmt::format("{:.5g}", *number.value) : "–");
    }
    report.table(header, rows);
  }
  write_file(folder / "index.html", report.text());
  return drawn;
}

}  // namespace scalebreak
