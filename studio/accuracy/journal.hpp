/// The trials of a study on disk as they end, so that one that was interrupted or killed can be taken up again.
#pragma once

#include <string>
#include <vector>

#include "studio/accuracy/study.hpp"

namespace wale {

/// A file of JSON lines: first by what the trials were made, then one each.
class Journal {
 public:
  /// What a trial depends on besides its knob.
  struct Origin {
    std::vector<Source> sources;  ///< the scene and all that it reads
    int threads = 1, times = 1;
  };

  /// Empties the file, or with `resume` reads what is in it but for a last line that was cut short. Throws
  /// std::system_error if it cannot be read or written, std::runtime_error if its origin is another.
  Journal(std::string path, const Origin&, bool resume);

  /// Nothing if it has not run.
  std::optional<Trial> find(const std::string& knob, const std::string& label) const;

  /// Is on disk when it returns. Throws std::system_error with the path.
  void keep(const std::string& knob, const Trial&);

  std::size_t size() const { return kept_.size(); }

 private:
  struct Kept {
    std::string knob;
    Trial trial;
  };
  void read(const std::string& origin);
  void append(const std::string& line) const;

  std::string path_;
  std::vector<Kept> kept_;
};

}  // namespace wale
