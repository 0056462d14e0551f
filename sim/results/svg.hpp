/// What pictures share: escaped text, round numbers on an axis, colours.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace wale::svg {

/// Text between tags or in an attribute.
std::string escape(std::string_view text);
/// `<text>` at a place, px; `anchor` is start, middle or end, `attributes` go into the tag.
std::string text(double x, double y, std::string_view anchor, std::string_view words, std::string_view attributes = "");
/// The opening tag of a picture of that size, px, with its font and a white ground.
std::string open(double width, double height);

/// The largest of 1, 2, 5 times a power of ten that is not above `most`; `most` is positive.
double round_below(double most);
/// Multiples of a round step within [low, high], at most `most` + 1 of them.
std::vector<double> ticks(double low, double high, int most);

using Colour = std::array<int, 3>;  ///< red, green, blue, 0 ... 255
std::string hex(const Colour&);
/// Dark blue over green to yellow for 0 ... 1: lightness grows evenly, so it reads in grey and to the colour-blind.
Colour gradient(double value);
/// Colours for things without order; they repeat after six.
Colour palette(int index);

}  // namespace wale::svg
