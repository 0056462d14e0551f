#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <exception>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "compiler/spelling.hpp"
#include "studio/cli/commands.hpp"
#include "studio/cli/complain.hpp"
#include "studio/cli/exit_code.hpp"

namespace {

int unknown_command(const char* name) {
  const std::string hint = wale::suggest(name, {"check", "compile", "run", "curve", "patterns", "accuracy", "explain"});
  return wale::complain("wale", fmt::format("there is no command \"{}\"", name), hint);
}

/// Gives large arrays, as matrices and factors are, pages of their own, which go back when they are freed. glibc would
/// soon keep those of up to 32 MB among the small ones, and their room between these. What small ones need for an
/// evaluation is kept from one to the next: to ask for it anew takes a seventh of a small swatch's time.
void set_up_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  set_up_memory();
  CLI::App app{"From a knitting chart to a stress-strain curve, yarn by yarn.", "wale"};
  app.set_version_flag("--version", WALE_VERSION);
  app.require_subcommand(1);
  int exit_code = wale::success;
  wale::add_check(app, exit_code);
  wale::add_compile(app, exit_code);
  wale::add_run(app, exit_code);
  wale::add_curve(app, exit_code);
  wale::add_patterns(app, exit_code);
  wale::add_accuracy(app, exit_code);
  wale::add_explain(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty()) return unknown_command(argv[1]);
    return app.exit(error) == 0 ? wale::success : wale::bad_input;
  } catch (const std::exception& error) {
    return wale::complain("wale", error.what());
  }
  return exit_code;
}
