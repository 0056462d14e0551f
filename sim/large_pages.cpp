#include "sim/large_pages.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <mutex>
#include <new>
#include <vector>

namespace wale::large_pages {
namespace {

constexpr std::size_t spare = 16;  // the share, one in so many, by which the next array of its kind may be larger

struct Block {
  void* memory = nullptr;
  std::size_t bytes = 0;
};

class Blocks {
 public:
  ~Blocks() {
    for (const Block& block : kept_) std::free(block.memory);
  }

  void* take(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    const Block block = holds(bytes) ? take_kept(bytes) : make(bytes);
    used_.emplace(block.memory, block.bytes);
    in_use_ += block.bytes;
    return block.memory;
  }

  void leave(void* memory) {
    const std::lock_guard lock(mutex_);
    const auto found = used_.find(memory);
    kept_.push_back({memory, found->second});
    in_use_ -= found->second;
    used_.erase(found);
  }

 private:
  /// The smallest that is kept, if it is large enough and not needlessly so.
  std::vector<Block>::iterator fitting(std::size_t bytes) {
    auto best = kept_.end();
    for (auto block = kept_.begin(); block != kept_.end(); ++block)
      if (block->bytes >= bytes && block->bytes / 2 <= bytes && (best == kept_.end() || block->bytes < best->bytes))
        best = block;
    return best;
  }
  bool holds(std::size_t bytes) { return fitting(bytes) != kept_.end(); }

  Block take_kept(std::size_t bytes) {
    const auto found = fitting(bytes);
    const Block block = *found;
    kept_.erase(found);
    return block;
  }

  /// Gives back what is kept longest, so that no more is held than was once in use.
  Block make(std::size_t bytes) {
    bytes = (bytes + bytes / spare + page - 1) / page * page;
    most_in_use_ = std::max(most_in_use_, in_use_ + bytes);
    std::size_t held = in_use_ + bytes;
    for (const Block& block : kept_) held += block.bytes;
    for (; held > most_in_use_ && !kept_.empty(); kept_.erase(kept_.begin())) {
      held -= kept_.front().bytes;
      std::free(kept_.front().memory);
    }
    void* const memory = std::aligned_alloc(page, bytes);
    if (!memory) throw std::bad_alloc();
    madvise(memory, bytes, MADV_HUGEPAGE);  // only advice: small pages serve as well
    return {memory, bytes};
  }

  std::mutex mutex_;
  std::map<void*, std::size_t> used_;
  std::vector<Block> kept_;  // left longest ago first
  std::size_t in_use_ = 0, most_in_use_ = 0;
};

Blocks& blocks() {
  static Blocks all;
  return all;
}

}  // namespace

void* take(std::size_t bytes) { return blocks().take(bytes); }

void leave(void* memory) { blocks().leave(memory); }

}  // namespace wale::large_pages
