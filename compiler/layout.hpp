/// Where each loop of a stitch graph lies, before it is drawn.
#pragma once

#include <string>
#include <vector>

#include "compiler/chart.hpp"
#include "compiler/stitch_graph.hpp"

namespace wale {

/// A loop in its place: column, row, and the side from which it was pulled.
struct PlacedLoop {
  int loop = 0;              ///< index into StitchGraph::loops
  int course = 0;            ///< 0 is the first knitted
  int wale = 0;              ///< 0 is the leftmost, seen from the face
  int sign = 1;              ///< s: +1 knit, -1 purl, seen from the face (outside, for a tube)
  int sign_above = 1;        ///< S: the sign of the loop pulled through this one; its own where none is
  int material = 0;          ///< index into the chart's yarns
  double stitch_length = 0;  ///< m
};

/// A knitted-in-place fabric: all courses full, each loop pulled through the one below.
struct Layout {
  Form form = Form::flat;
  int wales = 0, courses = 0;
  std::vector<std::vector<PlacedLoop>> rows;  ///< [course][wale]
  std::vector<int> from_left;                 ///< per course: 1 if knitted from left to right
  bool cast_on = true, bind_off = true;
};

/// One loop a line; counts courses and wales from 1. What `--show layout` prints.
std::string print(const Layout&);

}  // namespace wale
