#include <CLI/CLI.hpp>
#include <stdexcept>

#include "studio/cli/commands.hpp"
#include "studio/cli/complain.hpp"
#include "studio/cli/exit_code.hpp"

int main(int argc, char** argv) {
  CLI::App app{"From a knitting chart to a stress-strain curve, yarn by yarn.", "wale"};
  app.set_version_flag("--version", WALE_VERSION);
  app.require_subcommand(1);
  int exit_code = wale::success;
  wale::add_check(app, exit_code);
  wale::add_compile(app, exit_code);
  wale::add_run(app, exit_code);
  wale::add_curve(app, exit_code);
  wale::add_patterns(app, exit_code);
  wale::add_explain(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? wale::success : wale::bad_input;
  } catch (const std::runtime_error& error) {
    return wale::complain("wale", error.what());
  }
  return exit_code;
}
