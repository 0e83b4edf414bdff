#include <cstdio>
#include <exception>

#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/base/version.hpp>

#include "command.hpp"

namespace {

/// Exit statuses: the work failed, the input is wrong.
constexpr int failed = 1, wrong_input = 2;

int run(int argc, char** argv) {
  using namespace scalebreak::apps;
  CLI::App app("Where scaling laws for powder and granular simulations break", "scalebreak");
  app.set_version_flag("--version", fmt::format("scalebreak {}", scalebreak::version()));
  app.require_subcommand(1);
  app.footer("Each subcommand has --help; a scene's keys are listed by --print-defaults.");
  Options options;
  std::function<void()> job;
  add_collide(app, options, job);
  add_table(app, options, job);
  add_invariance(app, options, job);
  add_reproduce(app, options, job);
  add_run(app, options, job);
  add_compare(app, options, job);
  add_breakdown(app, options, job);
  add_advise(app, options, job);
  add_stability(app, options, job);
  add_tradeoff(app, options, job);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : wrong_input;
  }
  job();
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) throw scalebreak::WorkError("standard output cannot be written");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  gsl_set_error_handler_off();  // GSL's own would abort; every call's status is looked at instead
  try {
    return run(argc, argv);
  } catch (const scalebreak::InputError& error) {
    fmt::print(stderr, "scalebreak: {}\n", error.what());
    return wrong_input;
  } catch (const std::exception& error) {
    fmt::print(stderr, "scalebreak: {}\n", error.what());
    return failed;
  }
}
