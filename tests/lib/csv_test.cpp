#include <scalebreak/output/csv.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

TEST(Csv, HasAHeaderWithUnitsAndARowALine) {
  Csv csv({"time [s]", "law"});
  csv.add({0.5, "rps"});
  csv.add({1.0, "sup"});
  EXPECT_EQ(csv.text(), "time [s],law\n0.5,rps\n1,sup\n");
}

TEST(Csv, NumbersHaveSeventeenDigitsAndReadBackTheSame) {
  Csv csv({"x [-]"});
  csv.add({0.1});
  csv.add({1.0 / 3});
  csv.add({-6.02214076e-300});
  EXPECT_EQ(csv.text(), "x [-]\n0.10000000000000001\n0.33333333333333331\n-6.0221407600000001e-300\n");
  EXPECT_EQ(std::stod("0.33333333333333331"), 1.0 / 3);
}

TEST(Csv, CellsWithoutAValueAreEmpty) {
  Csv csv({"a", "b", "c"});
  csv.add({std::monostate{}, 1.0, std::monostate{}});
  EXPECT_EQ(csv.text(), "a,b,c\n,1,\n");
}

TEST(Csv, QuotesWordsThatHoldCommasQuotesOrLines) {
  Csv csv({"word"});
  csv.add({"a, b"});
  csv.add({"two\nlines"});
  csv.add({"the \"glass\""});
  EXPECT_EQ(csv.text(), "word\n\"a, b\"\n\"two\nlines\"\n\"the \"\"glass\"\"\"\n");
}

TEST(Csv, ARowOfAnotherWidthIsRefused) {
  Csv csv({"a", "b"});
  for (const std::vector<CsvCell>& row : {std::vector<CsvCell>{1.0}, {1.0, 2.0, 3.0}, {}}) {
    try {
      csv.add(row);
      ADD_FAILURE() << "a row of " << row.size() << " cells was taken";
    } catch (const WorkError& error) {
      EXPECT_EQ(error.what(), "a CSV row has " + std::to_string(row.size()) + " cells under 2 headers");
    }
  }
  EXPECT_EQ(csv.text(), "a,b\n");
}

}  // namespace
}  // namespace scalebreak
