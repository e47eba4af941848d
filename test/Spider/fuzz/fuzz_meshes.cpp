// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fuzz_meshes.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace fuzz {
namespace {

using Point = std::array<double, 3>;
using Triangle = std::array<std::size_t, 3>;

struct Soup
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

/// returns a grid; wrapped in u it is a tube, in v as well a torus, and with a half turn a Moebius strip, which can't
/// be oriented.
Soup grid(Random& random)
{
  enum Shape
  {
    sheet,
    tube,
    torus,
    strip_with_half_turn
  };
  const Shape shape = static_cast<Shape>(random.below(4));
  const int nu = random.between(shape == sheet ? 1 : 3, 7), nv = random.between(shape == torus ? 3 : 1, 6);
  const bool wraps_u = shape != sheet, wraps_v = shape == torus;
  const int rows = wraps_u ? nu : nu + 1, columns = wraps_v ? nv : nv + 1;
  Soup soup;
  const double bend = random.real(-1, 1), pi = std::acos(-1.);
  for(int i = 0; i < rows; ++i)
    for(int j = 0; j < columns; ++j)
    {
      const double u = 2 * pi * i / nu, v = 2 * pi * j / nv, across = j - nv / 2.;
      const double radius = shape == torus ? nu + std::cos(v) : shape == tube ? nu / 6. : nu + across * std::cos(u / 2);
      const double height = shape == torus ? std::sin(v) : shape == tube ? j : across * std::sin(u / 2);
      soup.points.push_back(shape == sheet ? Point{double(i), double(j), bend * (i * i + j * j) / 4}
                                           : Point{radius * std::cos(u), radius * std::sin(u), height});
    }
  const auto at = [&](int i, int j) {
    const int column = shape == strip_with_half_turn && i == nu ? nv - j : j;
    return static_cast<std::size_t>((i % rows) * columns + column % columns);
  };
  for(int i = 0; i < nu; ++i)
    for(int j = 0; j < nv; ++j)
    {
      const std::size_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if(random.one_in(2))
        soup.triangles.insert(soup.triangles.end(), {{a, b, c}, {a, c, d}});
      else
        soup.triangles.insert(soup.triangles.end(), {{a, b, d}, {b, c, d}});
    }
  return soup;
}

/// returns a double pyramid over a polygon: a tetrahedron-like or octahedron-like closed mesh, or a fan.
Soup pyramid(Random& random)
{
  const std::size_t corners = 3 + random.below(9);
  const bool is_closed = !random.one_in(3);
  Soup soup;
  for(std::size_t i = 0; i < corners; ++i)
  {
    const double angle = 2 * std::acos(-1.) * double(i) / double(corners);
    soup.points.push_back({std::cos(angle), std::sin(angle), 0});
  }
  soup.points.push_back({0, 0, random.real(0, 2)});
  soup.points.push_back({0, 0, -random.real(0, 2)});
  for(std::size_t i = 0; i < corners; ++i)
  {
    soup.triangles.push_back({i, (i + 1) % corners, corners});
    if(is_closed)
      soup.triangles.push_back({(i + 1) % corners, i, corners + 1});
  }
  return soup;
}

/// returns triangles between points at random: edges of many faces, faces twice, in all orientations,
/// self-intersections.
Soup tangle(Random& random)
{
  Soup soup;
  const std::size_t number_of_points = 3 + random.below(12);
  for(std::size_t i = 0; i < number_of_points; ++i)
    soup.points.push_back({random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)});
  for(std::size_t i = 1 + random.below(30); i-- > 0;)
  {
    const std::size_t a = random.below(number_of_points), b = random.below(number_of_points),
                      c = random.below(number_of_points);
    if(a != b && b != c && c != a)
      soup.triangles.push_back({a, b, c});
  }
  return soup;
}

void remove_faces(Soup& soup, Random& random)
{
  const std::size_t one_of = 2 + random.below(20);
  const auto is_removed = [&](const Triangle&) { return random.one_in(one_of); };
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(), is_removed), soup.triangles.end());
}

void add_another_component(Soup& soup, Random& random)
{
  const Soup other = pyramid(random);
  const std::size_t first = soup.points.size();
  soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
  for(const Triangle& t : other.triangles)
    soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

void crumple(Soup& soup, Random& random)
{
  const double amplitude = random.power_of_ten(-3, 0.5);
  for(Point& p : soup.points)
    for(double& x : p)
      x += amplitude * random.real(-1, 1);
}

/// puts points on a coarse lattice: faces without area, points in one place, folds.
void snap(Soup& soup, Random& random)
{
  const double cell = random.real(0.3, 3);
  for(Point& p : soup.points)
    for(double& x : p)
      x = cell * std::floor(x / cell);
}

void flatten(Soup& soup, Random& random)
{
  const std::size_t axis = random.below(3);
  const double factor = random.one_in(2) ? 1e-12 : random.one_in(2) ? 0 : random.power_of_ten(-20, 6);
  for(Point& p : soup.points)
    p[axis] *= factor;
}

void merge_points(Soup& soup, Random& random)
{
  for(std::size_t i = 1 + random.below(4); i-- > 0;)
    soup.points[random.below(soup.points.size())] = soup.points[random.below(soup.points.size())];
}

/// has all faces of a vertex become needles, or fold over.
void pull_vertex_away(Soup& soup, Random& random)
{
  Point& p = soup.points[random.below(soup.points.size())];
  const double distance = random.power_of_ten(-8, 8);
  for(double& x : p)
    x += distance * random.real(-1, 1);
}

void spoil_coordinate(Soup& soup, Random& random)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::array<double, 6> bad = {
    std::numeric_limits<double>::quiet_NaN(),  infinity, -infinity, std::numeric_limits<double>::max(),
    std::numeric_limits<double>::denorm_min(), -0.};
  soup.points[random.below(soup.points.size())][random.below(3)] = random.one_of(bad);
}

void scale(Soup& soup, Random& random)
{
  const std::array<double, 6> extremes = {1e300, 1e-300, 1e150, 1e-150, 1e-307, 1e30};
  const double factor = random.one_in(2) ? random.one_of(extremes) : random.power_of_ten(-12, 12);
  for(Point& p : soup.points)
    for(double& x : p)
      x *= factor;
}

void move_far_away(Soup& soup, Random& random)
{
  const double offset = random.one_in(2) ? 1e8 : random.power_of_ten(0, 18);
  for(Point& p : soup.points)
    p[0] += offset;
}

using Defect = void (*)(Soup&, Random&);
constexpr std::array<Defect, 10> defects = {remove_faces, add_another_component, crumple,          snap,
                                            flatten,      merge_points,          pull_vertex_away, spoil_coordinate,
                                            scale,        move_far_away};

/// orients what can be oriented, and cuts the rest apart; points without a face become isolated vertices or none.
Mesh mesh_of(Soup soup, bool with_isolated_vertices)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Kernel::Point_3> points;
  for(const Point& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  Mesh mesh;
  PMP::orient_polygon_soup(points, soup.triangles);
  if(PMP::is_polygon_soup_a_polygon_mesh(soup.triangles))
    PMP::polygon_soup_to_polygon_mesh(points, soup.triangles, mesh);
  if(with_isolated_vertices)
    mesh.add_vertex(points.front());
  return mesh;
}

} // namespace

Mesh random_mesh(Random& random)
{
  Soup soup = random.one_in(4) ? tangle(random) : random.one_in(4) ? pyramid(random) : grid(random);
  if(random.one_in(20))
    soup.triangles.resize(std::min<std::size_t>(soup.triangles.size(), 1));
  if(random.one_in(2))
    crumple(soup, random);
  for(std::size_t i = random.below(4); i-- > 0;)
    random.one_of(defects)(soup, random);
  return mesh_of(std::move(soup), random.one_in(5));
}

} // namespace fuzz
