#include "scene/meeting_boxes.hpp"

namespace tremolo::scene {

Box box_of(const std::vector<Point>& points) {
  Box box{points[0].x, points[0].y, points[0].x, points[0].y};
  for (const Point p : points)
    box = {std::min(box.x_min, p.x), std::min(box.y_min, p.y), std::max(box.x_max, p.x),
           std::max(box.y_max, p.y)};
  return box;
}

bool meet(const Box& a, const Box& b) {
  const double slack = box_tolerance * std::max({a.width(), a.height(), b.width(), b.height()});
  return a.x_min <= b.x_max + slack && b.x_min <= a.x_max + slack && a.y_min <= b.y_max + slack &&
         b.y_min <= a.y_max + slack;
}

std::vector<std::pair<std::size_t, std::size_t>> overlaps(const std::vector<Polygon>& polygons) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<Box> boxes;
  boxes.reserve(polygons.size());
  for (const Polygon& polygon : polygons)
    boxes.push_back(box_of(polygon));
  std::vector<std::size_t> overlapped(polygons.size(), none);
  for_each_meeting_pair(boxes, [&](std::size_t i, std::size_t j) {
    if (i < overlapped[j] && overlap(polygons[i], polygons[j]))
      overlapped[j] = i;
    return false;
  });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t j = 0; j < polygons.size(); ++j)
    if (overlapped[j] != none)
      pairs.emplace_back(overlapped[j], j);
  return pairs;
}

} // namespace tremolo::scene
