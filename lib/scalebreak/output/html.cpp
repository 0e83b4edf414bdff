#include <scalebreak/output/html.hpp>

#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include <scalebreak/base/version.hpp>

namespace scalebreak {
namespace {

constexpr const char* style = R"(
body { font: 16px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; color: #1a1a1a; }
h1, h2 { line-height: 1.2; } h2 { margin-top: 2.5rem; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; margin: 1rem 0; display: block; overflow-x: auto; } th, td { border: 1px solid #ccc; padding: .25rem .6rem; text-align: left; }
th { background: #f2f2f2; } figure { margin: 1.5rem 0; } figure svg { width: 100%; height: auto; } figcaption { color: #444; }
footer { margin-top: 3rem; color: #666; font-size: .85rem; }
)";

/// gnuplot names the parts of every drawing alike; in one page they must differ.
std::string with_own_ids(std::string svg, const std::string& prefix) {
  for (const std::string mark : {"id='", "id=\"", "href='#", "href=\"#", "url(#"}) {
    for (std::size_t at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at + mark.size() + prefix.size())) {
      svg.insert(at + mark.size(), prefix);
    }
  }
  return svg;
}

}  // namespace

std::string html_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

HtmlReport::HtmlReport(std::string title, std::string introduction) : title_(std::move(title)) {
  body_ = fmt::format("<h1>{}</h1>\n", html_escaped(title_));
  paragraph(introduction);
}

void HtmlReport::heading(const std::string& text) { body_ += fmt::format("<h2>{}</h2>\n", html_escaped(text)); }

void HtmlReport::paragraph(const std::string& text) { body_ += fmt::format("<p>{}</p>\n", html_escaped(text)); }

void HtmlReport::table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows) {
  body_ += "<table>\n<tr>";
  for (const auto& cell : header) body_ += fmt::format("<th>{}</th>", html_escaped(cell));
  body_ += "</tr>\n";
  for (const auto& row : rows) {
    body_ += "<tr>";
    for (const auto& cell : row) body_ += fmt::format("<td>{}</td>", html_escaped(cell));
    body_ += "</tr>\n";
  }
  body_ += "</table>\n";
}

void HtmlReport::figure(const std::filesystem::path& svg, const std::string& caption) {
  std::ifstream file(svg);
  std::string drawing(std::istreambuf_iterator<char>(file), {});
  const std::size_t start = drawing.find("<svg");
  drawing = start == std::string::npos
                ? fmt::format("<p>({} was not drawn: gnuplot is missing or failed; its script is kept beside the data.)</p>",
                              html_escaped(svg.filename().string()))
                : with_own_ids(drawing.substr(start), fmt::format("f{}", ++figures_));
  body_ += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", drawing, html_escaped(caption));
}

std::string HtmlReport::text() const {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}<footer>Made by scalebreak {}.</footer>\n</body>\n</html>\n",
      html_escaped(title_), style, body_, html_escaped(std::string(version())));
}

}  // namespace scalebreak
