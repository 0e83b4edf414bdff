#include <scalebreak/scene/toml_reader.hpp>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <lib/surroundings.hpp>
#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using tests::TemporaryFolder;

std::string sentence_for(const std::string& toml) {
  try {
    (void)read_toml(toml, "scene.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "(it was accepted)";
}

std::string sentence_for_setting(const std::string& text) {
  try {
    (void)read_setting(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "(it was accepted)";
}

TEST(TomlReader, FlattensInTheOrderOfTheLines) {
  const auto given =
      read_toml("# a pair\n[wall]\nrigid = true\n\n[contact]\nnormal = \"hertz\" # no adhesion\n[material]\nyoung = 1e9\npoisson = 0.3\n",
                "scene.toml");
  ASSERT_EQ(given.size(), 4u);
  const std::vector<std::pair<std::string, std::string>> wanted = {{"wall.rigid", "scene.toml, line 3"},
                                                                   {"contact.normal", "scene.toml, line 6"},
                                                                   {"material.young", "scene.toml, line 8"},
                                                                   {"material.poisson", "scene.toml, line 9"}};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(given[i].key, wanted[i].first);
    EXPECT_EQ(given[i].where.text, wanted[i].second);
  }
}

TEST(TomlReader, ReadsEveryKindOfValue) {
  const auto given =
      read_toml("a = 1.5\nb = -3\nc = true\nd = \"word\"\ne = [1, 2.5]\nf = ['x', \"y\"]\ng = []\nh = 10_000\ni = inf\n", "text");
  ASSERT_EQ(given.size(), 9u);
  EXPECT_EQ(given[0].value, Value(1.5));
  EXPECT_EQ(given[1].value, Value(-3.0));
  EXPECT_EQ(given[2].value, Value(true));
  EXPECT_EQ(given[3].value, Value(std::string("word")));
  EXPECT_EQ(given[4].value, Value(std::vector<double>{1, 2.5}));
  EXPECT_EQ(given[5].value, Value(std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(given[6].value, Value(std::vector<double>{}));
  EXPECT_EQ(given[7].value, Value(1e4));
  EXPECT_EQ(given[8].value, Value(std::numeric_limits<double>::infinity()));
}

TEST(TomlReader, NumbersTheBodies) {
  const auto given = read_toml("[[body]]\nradius = 1\n[[body]]\nradius = 2\n", "text");
  ASSERT_EQ(given.size(), 2u);
  EXPECT_EQ(given[0].key, "body.1.radius");
  EXPECT_EQ(given[1].key, "body.2.radius");
  EXPECT_EQ(given[1].where.text, "text, line 4");
}

TEST(TomlReader, TakesDottedKeysAndInlineTables) {
  const auto given = read_toml("material.young = 1e9\nimpact = { normal_speed = 2 }\n", "text");
  ASSERT_EQ(given.size(), 2u);
  EXPECT_EQ(given[0].key, "material.young");
  EXPECT_EQ(given[1].key, "impact.normal_speed");
}

TEST(TomlReader, CountsLinesThroughArraysAndCarriageReturns) {
  const auto given = read_toml("[pair]\r\nradius = [\r\n  1,\r\n  2,\r\n]\r\npartner = \"wall\"\r\n", "text");
  ASSERT_EQ(given.size(), 2u);
  EXPECT_EQ(given[0].where.text, "text, line 2");
  EXPECT_EQ(given[1].where.text, "text, line 6");
}

TEST(TomlReader, RefusesDatesAndTimes) {
  const std::string allowed = "; allowed: a number, true or false, a string, an array";
  EXPECT_EQ(sentence_for("[material]\nyoung = 1979-05-27\n"), "scene.toml, line 2: material.young: found a date or time" + allowed);
  EXPECT_EQ(sentence_for("young = 07:32:00"), "scene.toml, line 1: young: found a date or time" + allowed);
  EXPECT_EQ(sentence_for("young = 1979-05-27T07:32:00Z"), "scene.toml, line 1: young: found a date or time" + allowed);
}

TEST(TomlReader, RefusesMixedAndNestedArrays) {
  EXPECT_EQ(sentence_for("\na = [1, \"two\"]"), "scene.toml, line 2: a: an array holds numbers or strings, found both");
  EXPECT_EQ(sentence_for("a = [[1], [2]]"), "scene.toml, line 1: a: an array holds numbers or strings, found neither");
  EXPECT_EQ(sentence_for("a = [true, false]"), "scene.toml, line 1: a: an array holds numbers or strings, found neither");
  EXPECT_EQ(sentence_for("a = [{b = 1}, 2]"), "scene.toml, line 1: a: an array holds numbers or strings, found neither");
}

TEST(TomlReader, NamesTheLineOfWhatIsNotToml) {
  EXPECT_THAT(sentence_for("[material]\nyoung = 1e9\npoisson = = 3\n"), StartsWith("scene.toml, line 3: this is not TOML: "));
  EXPECT_THAT(sentence_for("[material\nyoung = 1e9\n"), StartsWith("scene.toml, line 1: this is not TOML: "));
  EXPECT_THAT(sentence_for("a = 1\n\na = 2\n"), StartsWith("scene.toml, line 3: this is not TOML: "));
  EXPECT_THAT(sentence_for("a = hertz"), StartsWith("scene.toml, line 1: this is not TOML: "));
  EXPECT_THAT(sentence_for("a = \"\xff\xfe\""), StartsWith("scene.toml, line 1: this is not TOML: "));
  EXPECT_THAT(sentence_for("a = " + std::string(1000, '[')), StartsWith("scene.toml, line 1: this is not TOML: "));
}

std::string repeated(const std::string& part, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += part;
  return all;
}

/// Reads a text in a process of its own, which a stack that runs over would kill.
void expect_survived(const std::string& text) {
  EXPECT_EXIT(((void)sentence_for(text), std::exit(3)), testing::ExitedWithCode(3), "") << text.substr(0, 40);
}

TEST(TomlReaderDeathTest, SurvivesKeysThatAreTooDeepForTheStack) {
  const std::string deep = repeated("a.", 300'000) + "a";
  for (const std::string& text :
       {deep + " = 1", fmt::format("[{}]\nb = 1", deep), fmt::format("a = {{{} = 1}}", deep), deep + " = 1 = 2"}) {
    expect_survived(text);
  }
}

TEST(TomlReaderDeathTest, SurvivesThemBehindQuotesAndHashesThatOpenNothing) {
  const std::string deep = repeated("a.", 300'000) + "a";
  const std::string texts[] = {R"("\"".)" + deep + " = 1",  // an escaped quote
                               "a = [{b = \"\"\"\n'\"\"\", " + deep + " = 1}]",
                               "a = [{b = '''\n\"''', " + deep + " = 1}]",
                               "a = [{b = \"\"\"\n#\"\"\", " + deep + " = 1}]",
                               "\"#\"." + deep + " = 1",
                               fmt::format("b{} = 1", repeated(".\"=\"", 300'000))};
  for (const std::string& text : texts) expect_survived(text);
}

TEST(TomlReaderDeathTest, SurvivesKeysThatAreDeepByTablesInTables) {
  const std::string key = repeated("b.", 62) + "b";
  for (const int tables : {100, 250}) {
    expect_survived(fmt::format("[{}]\n{} = {}1{}", key, key, repeated(fmt::format("{{{} = ", key), tables), repeated("}", tables)));
  }
}

TEST(TomlReader, RefusesMoreDotsThanAnyInputNeeds) {
  const std::string sentence = "found more than 3000 dots; allowed: fewer, an input needs no deeper keys nor more numbers";
  EXPECT_EQ(sentence_for("a = 1\n" + repeated("b.", 3001) + "b = 1"), "scene.toml, line 2: " + sentence);
  EXPECT_EQ(read_toml("a = 1 #" + std::string(3000, '.'), "text").size(), 1u);
}

TEST(TomlReaderDeathTest, SurvivesASettingAsLongAsACommandLineTakes) {
  const std::string setting = fmt::format("a={{{}b = 1}}", repeated("b.", 65'000));
  EXPECT_EXIT(((void)sentence_for_setting(setting), std::exit(3)), testing::ExitedWithCode(3), "");
}

TEST(TomlReader, AnEmptyTextGivesNothing) {
  EXPECT_TRUE(read_toml("", "text").empty());
  EXPECT_TRUE(read_toml("# only a remark\n", "text").empty());
}

TEST(TomlReader, NamesTheFileInMessages) {
  const TemporaryFolder folder;
  const auto file = folder / "pair.toml";
  tests::put_file(file, "a = 1\nb = 2\n");
  EXPECT_EQ(read_toml_file(file).at(1).where.text, file.string() + ", line 2");
}

TEST(TomlReader, RefusesFilesThatCannotBeRead) {
  const TemporaryFolder folder;
  for (const auto& path : {folder / "missing.toml", folder.path()}) {
    try {
      (void)read_toml_file(path);
      ADD_FAILURE() << path << " was read";
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), path.string() + ": there is no such file, or it cannot be read");
    }
  }
}

TEST(Setting, TakesEveryKindOfValue) {
  EXPECT_EQ(read_setting("material.young=1e9").value, Value(1e9));
  EXPECT_EQ(read_setting("material.young=-3").value, Value(-3.0));
  EXPECT_EQ(read_setting("contact.normal=hertz").value, Value(std::string("hertz")));
  EXPECT_EQ(read_setting("contact.normal=\"hertz\"").value, Value(std::string("hertz")));
  EXPECT_EQ(read_setting("wall.rigid=true").value, Value(true));
  EXPECT_EQ(read_setting("wall.rigid=false").value, Value(false));
  EXPECT_EQ(read_setting("pair.radius=[1e-3, 2e-3]").value, Value(std::vector<double>{1e-3, 2e-3}));
  EXPECT_EQ(read_setting("study.laws=[\"rps\",\"sup\"]").value, Value(std::vector<std::string>{"rps", "sup"}));
  EXPECT_EQ(read_setting("study.speeds=[]").value, Value(std::vector<double>{}));
  EXPECT_EQ(read_setting("material.name=fine-glass_2.5/a+b").value, Value(std::string("fine-glass_2.5/a+b")));
}

TEST(Setting, KnowsItsKeyAndWhereItWasFound) {
  const Assignment setting = read_setting("contact.normal=hertz");
  EXPECT_EQ(setting.key, "contact.normal");
  EXPECT_EQ(setting.where.text, "--set contact.normal=hertz");
}

TEST(Setting, RefusesWhatIsNoAssignment) {
  EXPECT_EQ(sentence_for_setting("contact.normal"), "--set contact.normal: allowed: dotted.key=value, like contact.normal=hertz");
  EXPECT_EQ(sentence_for_setting("=3"), "--set =3: allowed: dotted.key=value, like contact.normal=hertz");
  EXPECT_EQ(sentence_for_setting(""), "--set : allowed: dotted.key=value, like contact.normal=hertz");
}

TEST(Setting, RefusesValuesThatNoKeyHolds) {
  const std::string allowed = "; allowed: a number, a bare word, \"a string\", [an, array], true or false";
  EXPECT_EQ(sentence_for_setting("a.b="), "--set a.b=: found nothing" + allowed);
  EXPECT_EQ(sentence_for_setting("a.b=[rps, sup]"), "--set a.b=[rps, sup]: found [rps, sup]" + allowed);
  EXPECT_EQ(sentence_for_setting("a.b={c = 1}"), "--set a.b={c = 1}: found {c = 1}" + allowed);
  EXPECT_EQ(sentence_for_setting("a.b=two words"), "--set a.b=two words: found two words" + allowed);
  EXPECT_EQ(sentence_for_setting("a.b=1\nc = 2"), "--set a.b=1\nc = 2: found 1\nc = 2" + allowed);
  EXPECT_EQ(sentence_for_setting("a.b=1979-05-27"),
            "--set a.b=1979-05-27: a.b: found a date or time; allowed: a number, true or false, a string, an array");
  EXPECT_EQ(sentence_for_setting("a.b=[1, \"x\"]"), "--set a.b=[1, \"x\"]: a.b: an array holds numbers or strings, found both");
}

}  // namespace
}  // namespace scalebreak
