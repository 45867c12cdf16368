// Reads back what was drawn.
#pragma once

#include <string>
#include <vector>

namespace dualarm {

struct Pixel {
  double x;
  double y;
};

/// The corners of every path inside the plot's frame whose style holds `mark`, in the order of drawing.
std::vector<std::vector<Pixel>> paths_with(const std::string& svg, const std::string& mark);

/// The first of them, or nothing.
std::vector<Pixel> path_with(const std::string& svg, const std::string& mark);

/// The centres of all circles, legend included, whose style holds `mark`.
std::vector<Pixel> circles_with(const std::string& svg, const std::string& mark);

/// Whether it is an XML document with one `svg` element.
bool is_well_formed(const std::string& svg);

}  // namespace dualarm
