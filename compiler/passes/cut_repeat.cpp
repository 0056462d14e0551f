#include <stdexcept>

#include "compiler/passes.hpp"

namespace wale::passes {
namespace {

class Cutting {
 public:
  Cutting(const Curves& curves, const StitchGraph& graph, const Repeat& repeat)
      : curves_(curves), repeat_(repeat), width_(repeat.wales + 2 * repeat.margin) {
    starts_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(repeat.courses + 2 * repeat.margin));
    for (std::size_t yarn = 0; yarn < curves.yarns.size(); ++yarn) note_loops(yarn, graph);
  }

  Curves cut() const {
    Curves repeat;
    repeat.cell = {{mean_period(), 0, 0}, {0, height(), 0}};
    for (int course = 0; course < repeat_.courses; ++course) repeat.yarns.push_back(cut(course, repeat.cell->course));
    return repeat;
  }

 private:
  /// Where a loop begins.
  struct Start {
    std::size_t yarn = 0, piece = 0;
    bool drawn = false;
  };

  void note_loops(std::size_t yarn, const StitchGraph& graph) {
    const std::vector<CurvePiece>& pieces = curves_.yarns[yarn].pieces;
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
      if (pieces[piece].stitch < 0) continue;
      const ChartCell& cell = graph.loops[static_cast<std::size_t>(pieces[piece].stitch)].cell;
      Start& start = starts_[index(cell.course, cell.wale)];
      if (!start.drawn) start = {yarn, piece, true};
    }
  }

  std::size_t index(int course, int wale) const { return static_cast<std::size_t>(course * width_ + wale); }
  /// Counted from the first of the repeat.
  const Start& start(int course, int wale) const {
    return starts_[index(repeat_.margin + course, repeat_.margin + wale)];
  }
  Vec3 place(int course, int wale) const {
    const Start& at = start(course, wale);
    return curves_.yarns[at.yarn].pieces[at.piece].at(0).y;
  }

  double mean_period() const {
    double sum = 0;
    for (int course = 0; course < repeat_.courses; ++course)
      sum += place(course, repeat_.wales).x() - place(course, 0).x();
    return sum / repeat_.courses;
  }

  double height() const {
    double sum = 0;
    for (int wale = 0; wale < repeat_.wales; ++wale) sum += place(repeat_.courses, wale).y() - place(0, wale).y();
    return sum / repeat_.wales;
  }

  /// From the first stitch of a course to the same one of the next repeat. What the two are not the period apart is
  /// spread evenly over the pieces between.
  YarnCurve cut(int course, const Vec3& period) const {
    const Start &from = start(course, 0), &to = start(course, repeat_.wales);
    if (from.yarn != to.yarn) throw std::logic_error("cut_repeat: a course of several yarns");
    const auto& pieces = curves_.yarns[from.yarn].pieces;
    const Vec3 corner = place(0, 0);
    const Vec3 gap = place(course, repeat_.wales) - place(course, 0) - period;
    const auto count = static_cast<double>(to.piece - from.piece);
    YarnCurve cut;
    for (std::size_t k = from.piece; k < to.piece; ++k) {
      CurvePiece piece = pieces[k];
      const Vec3 step = gap / count, shift = corner + static_cast<double>(k - from.piece) * step;
      piece.at = [=, drawn = pieces[k].at](double u) {
        const CurvePiece::Point at = drawn(u);
        return CurvePiece::Point{at.y - shift - u * step, at.dy - step};
      };
      cut.pieces.push_back(std::move(piece));
    }
    return cut;
  }

  const Curves& curves_;
  Repeat repeat_;
  int width_;
  std::vector<Start> starts_;  // by course and wale of the larger piece
};

}  // namespace

Curves cut_repeat(const Curves& curves, const StitchGraph& graph, const Repeat& repeat) {
  return Cutting(curves, graph, repeat).cut();
}

}  // namespace wale::passes
