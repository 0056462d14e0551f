#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "sim/polyline.hpp"
#include "sim/results/picture.hpp"
#include "sim/results/stretch_strain.hpp"
#include "sim/results/svg.hpp"

namespace wale {
namespace {

constexpr int shades = 40;                           // colours of the strain scale
constexpr int pieces = 2;                            // a segment is cut in so many, each with its own depth
constexpr int steps = 2;                             // straight lines a piece
constexpr double margin = 24, head = 44, foot = 74;  // px

/// A short length of yarn, ready to draw.
struct Piece {
  int layer = 0;  ///< depth, greater is nearer
  int colour = 0;
  double width = 0;  ///< m
  Points axis;       ///< 3 x (steps + 1), m
};

struct Scale {
  double low = 0, high = 0;
  int shade(double strain) const {
    const double share = high > low ? (strain - low) / (high - low) : 0.0;
    return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * (shades - 1)));
  }
};

Scale scale_for(const std::vector<double>& strains, const PictureOptions& options) {
  if (options.strains) return {(*options.strains)[0], (*options.strains)[1]};
  if (strains.empty()) return {};
  const auto [low, high] = std::minmax_element(strains.begin(), strains.end());
  return {*low, *high};
}

/// Layers are thin beside a yarn, so that yarns that cross never share one.
double layer_height(const Fabric& fabric) {
  double diameter = fabric.materials.empty() ? 1 : fabric.materials.front().diameter;
  for (const Material& material : fabric.materials) diameter = std::min(diameter, material.diameter);
  return diameter / 12;
}

std::vector<Piece> cut(const Fabric& fabric, const Points& q, const std::vector<int>& colours) {
  const double height = layer_height(fabric);
  std::vector<Piece> all;
  for (int i = 0; i < fabric.segment_count(); ++i) {
    const Points axis = polyline(fabric, q, i, i, pieces * steps);
    for (int k = 0; k < pieces; ++k) {
      Piece piece;
      piece.axis = axis.middleCols(k * steps, steps + 1);
      piece.layer = static_cast<int>(std::floor(piece.axis.row(2).mean() / height));
      piece.colour = colours[static_cast<std::size_t>(i)];
      piece.width = fabric.material_of(i).diameter;
      all.push_back(std::move(piece));
    }
  }
  return all;
}

/// From metres to pixels: x to the right, y down.
struct Frame {
  double scale = 1, left = 0, top = 0;  ///< px/m, and the place of the picture's corner, m
  double width = 0, height = 0;         ///< of the fabric, px
  double x(double metres) const { return margin + scale * (metres - left); }
  double y(double metres) const { return head + scale * (top - metres); }
};

Frame frame_around(const std::vector<Piece>& all, double size) {
  if (all.empty()) return {1, 0, 0, size, size / 4};
  Vec3 low = all.front().axis.col(0), high = low;
  for (const Piece& piece : all) {
    const Vec3 radius = Vec3::Constant(piece.width / 2);
    low = low.cwiseMin(piece.axis.rowwise().minCoeff() - radius);
    high = high.cwiseMax(piece.axis.rowwise().maxCoeff() + radius);
  }
  const double scale = size / std::max(high.x() - low.x(), high.y() - low.y());
  return {scale, low.x(), high.y(), scale * (high.x() - low.x()), scale * (high.y() - low.y())};
}

/// A piece as an SVG path, both ends drawn out by `beyond` of its width.
std::string path(const Piece& piece, const Frame& frame, double beyond) {
  Points axis = piece.axis;
  const auto draw_out = [&](Eigen::Index end, Eigen::Index inner) {
    Eigen::Vector2d along = (piece.axis.col(end) - piece.axis.col(inner)).head<2>();
    if (along.norm() > 0) axis.col(end).head<2>() += beyond * piece.width * along.normalized();
  };
  draw_out(0, 1);
  draw_out(steps, steps - 1);
  std::string d;
  for (Eigen::Index i = 0; i < axis.cols(); ++i)
    d += fmt::format("{}{:.1f} {:.1f}", i == 0 ? "M" : "L", frame.x(axis(0, i)), frame.y(axis(1, i)));
  return d;
}

/// What is drawn over each other in one layer, each a little longer than the one before, so that it closes the joints
/// that the one before leaves in a bend, and no outline is left across the yarn.
struct Stroke {
  double width = 1, beyond = 0;  ///< of the yarn's width
  double dark = 0, light = 0;    ///< how much of the colour is ink or white
};
constexpr std::array<Stroke, 3> strokes{{{1.22, 0.10, 0.86, 0}, {1, 0.14, 0, 0}, {0.34, 0.18, 0, 0.22}}};

std::string tint(svg::Colour colour, const Stroke& stroke) {
  for (int& part : colour)
    part =
        static_cast<int>(std::lround(part * (1 - stroke.dark - stroke.light) + 255 * stroke.light + 16 * stroke.dark));
  return svg::hex(colour);
}

std::string draw_layer(const std::vector<const Piece*>& layer, const Frame& frame, bool by_stretch) {
  std::string svg;
  for (const Stroke& stroke : strokes) {
    std::map<std::pair<int, double>, std::string> paths;  // by colour and width
    for (const Piece* piece : layer) paths[{piece->colour, piece->width}] += path(*piece, frame, stroke.beyond);
    for (const auto& [key, d] : paths) {
      const svg::Colour colour = by_stretch ? svg::gradient(key.first / (shades - 1.0)) : svg::palette(key.first);
      svg += fmt::format("<path stroke=\"{}\" stroke-width=\"{:.1f}\" d=\"{}\"/>\n", tint(colour, stroke),
                         stroke.width * frame.scale * key.second, d);
    }
  }
  return svg;
}

std::string draw(const std::vector<Piece>& all, const Frame& frame, bool by_stretch) {
  std::map<int, std::vector<const Piece*>> layers;
  for (const Piece& piece : all) layers[piece.layer].push_back(&piece);
  std::string svg = "<g fill=\"none\" stroke-linejoin=\"round\">\n";
  for (const auto& [depth, layer] : layers) svg += draw_layer(layer, frame, by_stretch);
  return svg + "</g>\n";
}

std::string scale_bar(const Frame& frame, double y) {
  const double length = svg::round_below(0.25 * std::max(frame.width, 200.0) / frame.scale);
  const double end = margin + frame.scale * length;
  return fmt::format("<path fill=\"none\" stroke=\"#222\" stroke-width=\"2\" d=\"M{0} {1}v8h{2:.1f}v-8\"/>\n", margin,
                     y, end - margin) +
         svg::text((margin + end) / 2, y + 27, "middle", fmt::format("{:g} mm", 1e3 * length));
}

std::string strain_bar(const Scale& scale, double right, double y) {
  constexpr double width = 240;
  std::string svg;
  for (int i = 0; i < shades; ++i)
    svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"12\" fill=\"{}\"/>\n",
                       right - width + width * i / shades, y, width / shades + 0.5,
                       svg::hex(svg::gradient(i / (shades - 1.0))));
  for (const double tick : svg::ticks(100 * scale.low, 100 * scale.high, 4)) {
    const double x = right - width + width * (tick / 100 - scale.low) / (scale.high - scale.low);
    svg += fmt::format("<path stroke=\"#222\" d=\"M{:.1f} {:.1f}v5\"/>\n", x, y + 12);
    svg += svg::text(x, y + 32, "middle", fmt::format("{:.4g}", std::abs(tick) < 1e-12 ? 0.0 : tick));
  }
  return svg + svg::text(right - width - 12, y + 11, "end", "yarn strain, %");
}

/// The materials of which there is yarn.
std::set<int> materials_in(const Fabric& fabric) {
  std::set<int> found;
  for (const Segment& segment : fabric.segments) found.insert(segment.material);
  return found;
}

std::string material_key(const Fabric& fabric, const std::set<int>& used, double right, double y) {
  std::string svg;
  for (auto at = used.rbegin(); at != used.rend(); ++at) {
    const int i = *at;
    const std::string& name = fabric.materials[static_cast<std::size_t>(i)].name;
    svg += svg::text(right, y + 12, "end", name);
    right -= 8.2 * static_cast<double>(name.size()) + 20;
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\" fill=\"{}\" stroke=\"#241d1a\"/>\n", right + 6,
                       y + 7, svg::hex(svg::palette(i)));
    right -= 18;
  }
  return svg;
}

}  // namespace

std::string fabric_svg(const Fabric& fabric, const Points& q, const PictureOptions& options) {
  const bool by_stretch = options.colour_by == ColourBy::stretch;
  Scale scale;
  std::vector<int> colours;
  if (by_stretch) {
    const std::vector<double> strains = stretch_strains(fabric, q, options.rest);
    scale = scale_for(strains, options);
    for (const double strain : strains) colours.push_back(scale.shade(strain));
  } else {
    for (const Segment& segment : fabric.segments) colours.push_back(segment.material);
  }
  const std::vector<Piece> all = cut(fabric, q, colours);
  const Frame frame = frame_around(all, options.size);
  const double width = std::max(frame.width + 2 * margin, 560.0), below = head + frame.height + 18;
  std::string svg = svg::open(width, head + frame.height + foot);
  if (!options.title.empty())
    svg += svg::text(margin, 28, "start", options.title, "font-size=\"18\" font-weight=\"bold\"");
  svg += draw(all, frame, by_stretch) + scale_bar(frame, below);
  if (by_stretch) svg += strain_bar(scale, width - margin, below);
  const std::set<int> used = materials_in(fabric);
  if (!by_stretch && used.size() > 1) svg += material_key(fabric, used, width - margin, below);
  return svg + "</svg>\n";
}

}  // namespace wale
