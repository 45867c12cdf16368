#include "tests/clients/svg_paths.h"

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <sstream>

namespace dualarm {
namespace {

// What stands between `before` and the next quotation mark, from `position` on; moves `position` behind it.
std::string quoted(const std::string& text, const std::string& before, std::size_t& position) {
  const std::size_t begin = text.find(before, position);
  if (begin == std::string::npos) return "";
  const std::size_t end = text.find('"', begin + before.size());
  position = end;
  return text.substr(begin + before.size(), end - begin - before.size());
}

std::vector<Pixel> corners_of(std::string data) {
  std::replace_if(
      data.begin(), data.end(), [](char c) { return c == 'M' || c == 'Z' || c == ','; }, ' ');
  std::istringstream numbers(data);
  std::vector<Pixel> corners;
  for (Pixel corner{}; numbers >> corner.x >> corner.y;) corners.push_back(corner);
  return corners;
}

}  // namespace

std::vector<std::vector<Pixel>> paths_with(const std::string& svg, const std::string& mark) {
  const std::size_t begin = svg.find("clip-path=");
  if (begin == std::string::npos) return {};
  const std::string inside = svg.substr(begin, svg.find("</g>", begin) - begin);
  std::vector<std::vector<Pixel>> paths;
  for (std::size_t position = 0;;) {
    const std::string data = quoted(inside, "<path d=\"", position);
    if (data.empty()) return paths;
    if (quoted(inside, "style=\"", position).find(mark) != std::string::npos) paths.push_back(corners_of(data));
  }
}

std::vector<Pixel> path_with(const std::string& svg, const std::string& mark) {
  const auto paths = paths_with(svg, mark);
  return paths.empty() ? std::vector<Pixel>{} : paths.front();
}

std::vector<Pixel> circles_with(const std::string& svg, const std::string& mark) {
  std::vector<Pixel> centres;
  for (std::size_t position = 0;;) {
    const std::string x = quoted(svg, "<circle cx=\"", position);
    if (x.empty()) return centres;
    const std::string y = quoted(svg, "cy=\"", position);
    if (quoted(svg, "style=\"", position).find(mark) != std::string::npos) centres.push_back({stod(x), stod(y)});
  }
}

bool is_well_formed(const std::string& svg) {
  std::istringstream stream(svg);
  boost::property_tree::ptree tree;
  try {
    boost::property_tree::read_xml(stream, tree);
  } catch (const boost::property_tree::xml_parser_error&) {
    return false;
  }
  return tree.size() == 1 && tree.front().first == "svg";
}

}  // namespace dualarm
