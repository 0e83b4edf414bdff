#include <scalebreak/output/html.hpp>

#include <gmock/gmock.h>

#include <lib/surroundings.hpp>
#include <scalebreak/base/version.hpp>

namespace scalebreak {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Html, EscapesWhatHtmlReadsAsItsOwn) {
  EXPECT_EQ(html_escaped("a < b & c > \"d\""), "a &lt; b &amp; c &gt; &quot;d&quot;");
  EXPECT_EQ(html_escaped("&lt;"), "&amp;lt;");
  EXPECT_EQ(html_escaped("E* = 5 GPa, γ"), "E* = 5 GPa, γ");
}

TEST(Html, IsAPageWithTitleAndVersion) {
  const std::string page = HtmlReport("Laws", "All of them.").text();
  EXPECT_THAT(page, StartsWith("<!doctype html>\n<html"));
  EXPECT_THAT(page, HasSubstr("<title>Laws</title>"));
  EXPECT_THAT(page, HasSubstr("<h1>Laws</h1>\n<p>All of them.</p>"));
  EXPECT_THAT(page, HasSubstr(html_escaped(std::string(version()))));
  EXPECT_THAT(page, HasSubstr("charset=\"utf-8\""));
  EXPECT_THAT(page, testing::EndsWith("</html>\n"));
}

TEST(Html, NeedsNoOtherFileAndNoNetwork) {
  const std::string page = HtmlReport("Laws", "All of them.").text();
  for (const char* mark : {"<script", "src=", "<link", "http://", "https://"}) EXPECT_THAT(page, Not(HasSubstr(mark)));
}

TEST(Html, EscapesEveryText) {
  HtmlReport report("<title>", "<intro>");
  report.heading("<heading>");
  report.paragraph("<paragraph>");
  report.table({"<header>"}, {{"<cell>"}, {"a & b"}});
  report.figure("/nowhere/<figure>.svg", "<caption>");
  const std::string page = report.text();
  for (const char* word : {"title", "intro", "heading", "paragraph", "header", "cell", "figure", "caption"}) {
    EXPECT_THAT(page, HasSubstr("&lt;" + std::string(word))) << word;
  }
  for (const char* word : {"<intro>", "<heading>", "<paragraph>", "<cell>", "<figure>.svg", "<caption>", "a & b"})
    EXPECT_THAT(page, Not(HasSubstr(word)));
}

TEST(Html, KeepsTheOrderInWhichThingsWereAdded) {
  HtmlReport report("Laws", "Intro.");
  report.heading("First");
  report.table({"law", "e"}, {{"rps", "kept"}, {"sup", "0.8"}});
  report.paragraph("Then.");
  const std::string table =
      "<table>\n<tr><th>law</th><th>e</th></tr>\n<tr><td>rps</td><td>kept</td></tr>\n<tr><td>sup</td><td>0.8</td></tr>\n</table>\n";
  EXPECT_THAT(report.text(), HasSubstr("<p>Intro.</p>\n<h2>First</h2>\n" + table + "<p>Then.</p>\n"));
}

TEST(Html, SaysWhichFigureIsMissing) {
  const tests::TemporaryFolder folder;
  HtmlReport report("Laws", "Intro.");
  report.figure(folder / "restitution.svg", "Restitution over speed.");
  const std::string sentence = "(restitution.svg was not drawn: gnuplot is missing or failed; its script is kept beside the data.)";
  EXPECT_THAT(report.text(), HasSubstr("<figure><p>" + sentence + "</p><figcaption>Restitution over speed.</figcaption></figure>"));
}

TEST(Html, PutsDrawingsInWithNamesThatDiffer) {
  const tests::TemporaryFolder folder;
  tests::put_file(folder / "a.svg",
                  "<?xml version=\"1.0\"?>\n<svg><path id='gp1' clip-path='url(#gp1)'/><use xlink:href='#gp1'/><g id=\"other\"/></svg>");
  HtmlReport report("Laws", "Intro.");
  report.figure(folder / "a.svg", "One.");
  report.figure(folder / "a.svg", "Two.");
  const std::string page = report.text();
  EXPECT_THAT(page, Not(HasSubstr("<?xml")));
  EXPECT_THAT(page, HasSubstr("<figure><svg><path id='f1gp1' clip-path='url(#f1gp1)'/><use xlink:href='#f1gp1'/><g "
                              "id=\"f1other\"/></svg><figcaption>One."));
  EXPECT_THAT(page, HasSubstr("<figure><svg><path id='f2gp1' clip-path='url(#f2gp1)'/><use xlink:href='#f2gp1'/><g "
                              "id=\"f2other\"/></svg><figcaption>Two."));
}

}  // namespace
}  // namespace scalebreak
