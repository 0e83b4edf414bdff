#include <gmock/gmock.h>

#include <apps/program.hpp>
#include <lib/resolving.hpp>

namespace scalebreak::tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

struct CommandLine : ProgramTest {};

constexpr const char* subcommands[] = {"collide", "table", "invariance"};

TEST_F(CommandLine, VersionNamesTheCommit) {
  const ProgramRun version = run({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out, testing::MatchesRegex("scalebreak [0-9]+\\.[0-9]+\\.[0-9]+ \\(commit [^ ()]+\\)\n"));
  if (std::system("git -C '" SCALEBREAK_SOURCE "' describe --always >/dev/null 2>&1") == 0) {
    EXPECT_THAT(version.out, testing::Not(HasSubstr("unknown")));
  }
}

TEST_F(CommandLine, HelpListsTheSubcommandsAndTheirOptions) {
  const ProgramRun help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* subcommand : subcommands) {
    EXPECT_THAT(help.out, HasSubstr(subcommand));
    const ProgramRun own = run({subcommand, "--help"});
    EXPECT_EQ(own.status, 0) << subcommand;
    for (const char* option : {"FILE.toml", "--set", "--out", "--tables", "--json", "--threads", "--check", "--quiet"})
      EXPECT_THAT(own.out, HasSubstr(option)) << subcommand;
  }
}

TEST_F(CommandLine, FlowsAreNoBusinessOfPairs) {
  for (const char* subcommand : subcommands) {
    const ProgramRun flow = run({subcommand, "--set", "cell.kind=shear"});
    EXPECT_EQ(flow.status, 2) << subcommand;
    EXPECT_EQ(flow.err,
              "scalebreak: --set: [particles] or [cell] make a flow, which this command does not take; allowed: a pair or bodies\n");
  }
}

TEST_F(CommandLine, WhatItDoesNotKnowEndsWithStatusTwo) {
  const std::vector<std::vector<std::string>> wrong = {{},
                                                       {"collapse"},
                                                       {"--nonsense"},
                                                       {"collide", "--nonsense"},
                                                       {"collide", "--threads", "many"},
                                                       {"collide", "--threads", "-1"},
                                                       {"collide", "--set"},
                                                       {"collide", "a.toml", "b.toml"}};
  for (const auto& words : wrong) {
    const ProgramRun result = run(words);
    EXPECT_EQ(result.status, 2) << testing::PrintToString(words);
    EXPECT_THAT(result.err, testing::Not(IsEmpty())) << testing::PrintToString(words);
    EXPECT_THAT(result.out, IsEmpty()) << testing::PrintToString(words);
  }
}

TEST_F(CommandLine, WrongInputEndsWithStatusTwoASentenceAndNothingWritten) {
  const std::string file = scene("pair.toml", "[contact]\nnormal = \"jkr\"\n[material]\nyoung = -1\n");
  for (const char* subcommand : subcommands) {
    const ProgramRun result = run({subcommand, file, "--out", out, "--tables", tables, "--json"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err,
              "scalebreak: " + file + ", line 4: material.young: found -1; allowed: a number of at least 100 and at most 1e+14\n");
    EXPECT_THAT(result.out, IsEmpty());
    EXPECT_FALSE(std::filesystem::exists(out) || std::filesystem::exists(tables)) << subcommand;
  }
}

TEST_F(CommandLine, AMissingFileEndsWithStatusTwo) {
  for (const char* subcommand : subcommands) {
    const ProgramRun result = run({subcommand, folder / "missing.toml", "--out", out});
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.err, HasSubstr("missing.toml: there is no such file, or it cannot be read"));
    EXPECT_FALSE(std::filesystem::exists(out));
  }
}

TEST_F(CommandLine, SettingsAreRepeatableTakeOneWordEachAndStandAnywhere) {
  const std::string file = scene("pair.toml", "[impact]\nnormal_speed = 0.3\n");
  const ProgramRun result = run(
      {"collide", "--set", "material.young=2e9", file, "--set", "pair.radius=[1e-3, 2e-3]", "--set", "contact.normal=hertz", "--check"});
  EXPECT_EQ(result.status, 0) << result.err;
  const Input input = resolved(result.out);
  EXPECT_EQ(input.material.young, 2e9);
  EXPECT_EQ(input.radius, (std::vector{1e-3, 2e-3}));
  EXPECT_EQ(input.contact.normal, NormalModel::hertz);
  EXPECT_EQ(input.normal_speed, 0.3);
}

TEST_F(CommandLine, AWrongSettingIsNamedAsItWasGiven) {
  const ProgramRun result = run({"collide", "--set", "impact.normal_speed=0"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err,
            "scalebreak: --set impact.normal_speed=0: impact.normal_speed: found 0; allowed: a number of at least 1e-09 and at most "
            "10000\n");
}

TEST_F(CommandLine, CheckPrintsTheResolvedInputWithAnEstimateAndStops) {
  const std::string file = scene("pair.toml", "[material]\nname = \"latex\"\n[impact]\nnormal_speed = 0.3\n");
  for (const char* subcommand : subcommands) {
    const ProgramRun result = run({subcommand, file, "--check", "--out", out, "--tables", tables});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("# estimate: "));
    EXPECT_TRUE(resolved(result.out) == resolved(content_of(file))) << result.out;
    EXPECT_FALSE(std::filesystem::exists(out) || std::filesystem::exists(tables)) << subcommand;
  }
}

TEST_F(CommandLine, CheckRefusesWrongInputToo) { EXPECT_EQ(run({"collide", "--check", "--set", "material.poisson=0.7"}).status, 2); }

TEST_F(CommandLine, PrintDefaultsIsAnInputOfTheDefaults) {
  for (const char* subcommand : subcommands) {
    const ProgramRun result = run({subcommand, "--print-defaults"});
    EXPECT_EQ(result.status, 0);
    EXPECT_TRUE(resolved(result.out) == Input{}) << subcommand;
    EXPECT_THAT(result.out, HasSubstr("[m/s] speed of approach at first touch; allowed: a number of at least 1e-09 and at most 10000"));
  }
}

TEST_F(CommandLine, InJsonCheckAndPrintDefaultsAreOneObjectToo) {
  for (const char* subcommand : subcommands) {
    const ProgramRun check = run({subcommand, "--check", "--json", "--set", "impact.normal_speed=0.3"});
    ASSERT_EQ(check.status, 0) << check.err;
    const nlohmann::json checked = check.json()["checked"];
    ASSERT_EQ(checked.size(), 1u);
    EXPECT_EQ(keys_of(checked[0]), (std::set<std::string>{"file", "estimate", "input"}));
    EXPECT_TRUE(resolved(checked[0]["input"].get<std::string>()) == resolved("", {"impact.normal_speed=0.3"})) << subcommand;
    EXPECT_TRUE(resolved(run({subcommand, "--print-defaults", "--json"}).json()["keys"].get<std::string>()) == Input{}) << subcommand;
  }
}

TEST_F(CommandLine, OutputThatCannotBeWrittenFailsWithStatusOne) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  for (const char* arguments : {"collide", "collide --json", "collide --check", "collide --print-defaults"}) {
    const std::string command = std::string("'" SCALEBREAK_PROGRAM "' ") + arguments + " >/dev/full 2>/dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1) << arguments;
  }
}

TEST_F(CommandLine, AFolderThatCannotBeMadeFailsWithStatusOne) {
  const std::string taken = scene("taken", "a file\n");
  const ProgramRun result = run({"collide", "--out", taken + "/out", "--json"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, StartsWith("scalebreak: cannot make the folder " + taken + "/out: "));
  EXPECT_THAT(result.out, IsEmpty());
}

}  // namespace
}  // namespace scalebreak::tests
