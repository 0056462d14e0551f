/// Segments cut into blocks of adjacent ones, as the kernels take them, in an order that threads can share.
#pragma once

#include <vector>

#include "sim/fabric.hpp"
#include "sim/kernels/along_yarn_block.hpp"

namespace wale {

/// `count` of SegmentBlocks::segments(), from `begin` on: adjacent ones of one yarn.
struct SegmentBlock {
  std::size_t begin = 0, count = 0;
  bool at_end = false;  ///< it is the first or the last segment of its yarn, alone, since it was asked to be
  std::size_t end() const { return begin + count; }
};

class SegmentBlocks {
 public:
  /// `ends_alone`: the first and the last segment of a yarn are blocks of their own.
  SegmentBlocks(const Fabric&, std::vector<int> segments, bool ends_alone);

  const std::vector<int>& segments() const { return segments_; }
  /// Colour by colour.
  const std::vector<SegmentBlock>& all() const { return blocks_; }
  /// Ranges [first, last) of all(). Blocks of one colour share no control point: threads may add to all of them at
  /// once, and every sum has the same bits for any number of threads if the colours follow each other.
  struct Colour {
    std::size_t first = 0, last = 0;
  };
  const std::vector<Colour>& colours() const { return colours_; }

 private:
  std::vector<int> segments_;
  std::vector<SegmentBlock> blocks_;
  std::vector<Colour> colours_;
};

}  // namespace wale
