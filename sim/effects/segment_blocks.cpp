#include "sim/effects/segment_blocks.hpp"

#include <algorithm>

namespace wale {
namespace {

bool is_end(const Fabric& fabric, int segment) {
  const Yarn& yarn = fabric.yarns[static_cast<std::size_t>(fabric.segment(segment).yarn)];
  const int place = segment - yarn.first_segment;
  return place == 0 || place == yarn.segments - 1;
}

std::vector<SegmentBlock> cut(const Fabric& fabric, const std::vector<int>& segments, bool ends_alone) {
  std::vector<SegmentBlock> blocks;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const bool alone = ends_alone && is_end(fabric, segments[i]);
    const bool goes_on = i > 0 && segments[i] == segments[i - 1] + 1 &&
                         fabric.segment(segments[i]).yarn == fabric.segment(segments[i - 1]).yarn;
    if (goes_on && !alone && !blocks.back().at_end && blocks.back().count < block_length)
      ++blocks.back().count;
    else
      blocks.push_back({i, 1, alone});
  }
  return blocks;
}

}  // namespace

SegmentBlocks::SegmentBlocks(const Fabric& fabric, std::vector<int> segments, bool ends_alone)
    : segments_(std::move(segments)) {
  // For each colour, the blocks that have it; each block takes the first colour that none of its points has yet.
  std::vector<std::vector<SegmentBlock>> by_colour;
  std::vector<std::vector<bool>> taken;
  for (const SegmentBlock& block : cut(fabric, segments_, ends_alone)) {
    const int first = fabric.first_point(segments_[block.begin]);
    const auto is_free = [&](const std::vector<bool>& points) {
      return std::none_of(points.begin() + first, points.begin() + first + static_cast<int>(block.count) + 3,
                          [](bool point) { return point; });
    };
    const auto colour = static_cast<std::size_t>(std::find_if(taken.begin(), taken.end(), is_free) - taken.begin());
    if (colour == taken.size()) {
      taken.emplace_back(static_cast<std::size_t>(fabric.points.cols()));
      by_colour.emplace_back();
    }
    std::fill_n(taken[colour].begin() + first, block.count + 3, true);
    by_colour[colour].push_back(block);
  }
  for (const std::vector<SegmentBlock>& some : by_colour) {
    colours_.push_back({blocks_.size(), blocks_.size() + some.size()});
    blocks_.insert(blocks_.end(), some.begin(), some.end());
  }
}

}  // namespace wale
