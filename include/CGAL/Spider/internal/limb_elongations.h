// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How much longer limbs may be along one direction than across it. What a radius blurs it blurs by direction: the waves
// across a ridge, but not the ridge. Two radii differ by that, as tensors. Along the direction in which they differ
// least limbs may be longer, if they are shorter across: an ellipse of the same area.

#ifndef CGAL_SPIDER_INTERNAL_LIMB_ELONGATIONS_H
#define CGAL_SPIDER_INTERNAL_LIMB_ELONGATIONS_H

#include <CGAL/Spider/internal/Neighbours.h>
#include <CGAL/Spider/internal/local_steps.h>
#include <CGAL/Spider/internal/numbers.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spider {
namespace internal {

/// Of two radii that tell by what they differ what is blurred, one is twice the other where there are as large ones.
/// Were they one rung apart, errors at suggested radii would be up to 6 % greater.
constexpr int rungs_apart = 2;

/// returns what a spider of about the given rung blurs, as a tensor. Its size is that of the difference and not the
/// square of it, lest one fit that is far off decide for all around it.
template <typename Scalar>
Tensor3<Scalar> blurring_at(const Climbed_vertex<Scalar>& climbed, Scalar rung)
{
  const int last = climbed.usable - 1;
  const int from = std::max(0, std::min(static_cast<int>(std::lround(rung)), last - rungs_apart));
  const Tensor3<Scalar> difference = climbed.tensors[std::min(from + rungs_apart, last)] - climbed.tensors[from];
  const Scalar size = difference.norm();
  if(!(size > 0))
    return Tensor3<Scalar>::Zero();
  return difference * difference / size;
}

/// returns a tangent vector along which limbs may be as many times as long as across as it is long; zero where nothing
/// is blurred. `noise` is how large what noise alone adds to blurring is.
template <typename Scalar>
Vec3<Scalar> elongation_of(const Tensor3<Scalar>& blurring, const Vec3<Scalar>& normal, Scalar noise)
{
  constexpr Scalar longest = 2; // much longer ones gain on some shapes what they lose on others
  // What noise adds differs by direction, too: by chance, and where edges are longer in one. Both shall not pass for a
  // ridge. With these, errors are up to 2 % greater than with discs on a noisy sphere, and up to 10 % on a torus of
  // edges 1 : 3. Without, it would be up to 14 and 42 %; but on shapes of mixed scale, where they are 6 % less than with
  // discs, they would be 7 % less.
  constexpr Scalar by_chance = Scalar(1.5), share_of_noise = Scalar(0.1);
  constexpr Scalar rounding = Scalar(1e-9); // a surface that bends by less per edge is a plane
  const Tensor3<Scalar> onto_plane = Tensor3<Scalar>::Identity() - normal * normal.transpose();
  Eigen::SelfAdjointEigenSolver<Tensor3<Scalar>> solver;
  solver.computeDirect(Tensor3<Scalar>(onto_plane * blurring * onto_plane));
  const Vec3<Scalar> along = unit<Scalar>(normal.cross(solver.eigenvectors().col(2)));
  const Scalar across_it = solver.eigenvalues()(2), along_it = std::max(along.dot(blurring * along), Scalar(0));
  if(!along.allFinite() || !(across_it > rounding))
    return Vec3<Scalar>::Zero();
  const Scalar ratio = (across_it + share_of_noise * noise) / (along_it + share_of_noise * noise);
  return std::max(Scalar(1), std::min(ratio / by_chance, longest)) * along;
}

/// returns the elongations of limbs near each vertex, given the vertices that climbed, and the rungs of all and what
/// noise makes estimates differ by there. They are smooth: blurring is averaged over about a hundred vertices.
template <typename ConcurrencyTag, typename Scalar>
std::vector<Vec3<Scalar>> limb_elongations(const std::vector<Climbed_vertex<Scalar>>& climbed,
                                           const Neighbours& neighbours, const std::vector<Scalar>& rungs,
                                           const std::vector<Scalar>& noise)
{
  constexpr int rounds = 20;
  constexpr int upper_triangle[6][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};
  std::vector<std::array<Scalar, 9>> sums(rungs.size()); // of blurring and of normals
  for(const Climbed_vertex<Scalar>& at : climbed)
  {
    const Tensor3<Scalar> blurring = blurring_at(at, rungs[at.vertex]);
    for(int i = 0; i < 6; ++i)
      sums[at.vertex][i] = blurring(upper_triangle[i][0], upper_triangle[i][1]);
    for(int i = 0; i < 3; ++i)
      sums[at.vertex][6 + i] = at.normal[i];
  }
  neighbours.average<ConcurrencyTag>(sums, rounds);

  std::vector<Vec3<Scalar>> elongations(rungs.size(), Vec3<Scalar>::Zero());
  for(std::size_t v = 0; v < rungs.size(); ++v)
  {
    Tensor3<Scalar> blurring;
    for(int i = 0; i < 6; ++i)
      blurring(upper_triangle[i][0], upper_triangle[i][1]) = blurring(upper_triangle[i][1], upper_triangle[i][0]) =
        sums[v][i];
    const Vec3<Scalar> normal = unit(Vec3<Scalar>(sums[v][6], sums[v][7], sums[v][8]));
    if(normal.allFinite())
      elongations[v] = elongation_of(blurring, normal, noise[v]);
  }
  return elongations;
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_LIMB_ELONGATIONS_H
