/// Runs the real command, as a user or a script would.
#pragma once

#include <string>
#include <vector>

namespace wale::test {

struct Answer {
  int exit_code = -1;
  std::string out, err;
  std::string first_error_line() const { return err.substr(0, err.find('\n')); }
};

/// A folder that is made anew for a test, and removed after it.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  /// Writes a file, gives its path.
  std::string write(const std::string& name, const std::string& text) const;
  /// Names of what lies in the folder, sorted.
  std::vector<std::string> names() const;

 private:
  std::string folder_;
};

/// `wale` with these arguments; with `interrupt_when` it gets SIGINT as soon as that file is there.
Answer wale(const std::vector<std::string>& arguments, const std::string& interrupt_when = {});

std::string read(const std::string& path);
/// All rows of numbers of a comma-separated table, without its header.
std::vector<std::vector<double>> numbers(const std::string& csv);

}  // namespace wale::test
