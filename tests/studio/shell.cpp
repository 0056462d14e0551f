#include "tests/studio/shell.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace wale::test {
namespace {

namespace fs = std::filesystem;

/// In the child: never comes back.
[[noreturn]] void become_wale(const std::vector<std::string>& arguments, const std::string& out,
                              const std::string& err) {
  constexpr int flags = O_CREAT | O_WRONLY | O_TRUNC;
  ::dup2(::open(out.c_str(), flags, 0600), STDOUT_FILENO);
  ::dup2(::open(err.c_str(), flags, 0600), STDERR_FILENO);
  ::setenv("OMP_NUM_THREADS", "1", 1);  // tests run side by side already
  std::vector<char*> words{const_cast<char*>(WALE_COMMAND)};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  ::execv(WALE_COMMAND, words.data());
  ::_exit(127);
}

int exit_code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

int wait_for(pid_t child, const std::string& interrupt_when) {
  int status = 0;
  while (!interrupt_when.empty() && !fs::exists(interrupt_when)) {
    if (::waitpid(child, &status, WNOHANG) == child) return exit_code_of(status);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (!interrupt_when.empty()) ::kill(child, SIGINT);
  ::waitpid(child, &status, 0);
  return exit_code_of(status);
}

}  // namespace

Scratch::Scratch() {
  std::string pattern = (fs::temp_directory_path() / "wale-test-XXXXXX").string();
  if (!::mkdtemp(pattern.data())) throw std::runtime_error("no scratch folder");
  folder_ = pattern;
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string Scratch::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name)) << text;
  return path(name);
}

std::vector<std::string> Scratch::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

Answer wale(const std::vector<std::string>& arguments, const std::string& interrupt_when) {
  const Scratch scratch;
  const std::string out = scratch.path("out"), err = scratch.path("err");
  const pid_t child = ::fork();
  if (child == 0) become_wale(arguments, out, err);
  const int exit_code = wait_for(child, interrupt_when);
  return {exit_code, read(out), read(err)};
}

std::string read(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<std::vector<double>> numbers(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(csv);
  std::string line, cell;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    while (std::getline(cells, cell, ',')) rows.back().push_back(cell.empty() ? 0 : std::stod(cell));
  }
  return rows;
}

}  // namespace wale::test
