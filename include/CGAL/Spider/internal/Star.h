// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_STAR_H
#define CGAL_SPIDER_INTERNAL_STAR_H

#include <CGAL/Spider/internal/Local_coordinates.h>
#include <CGAL/Spider/internal/Site.h>

#include <boost/container/small_vector.hpp>

namespace CGAL {
namespace Spider {
namespace internal {

/// An edge of the rim around a site, with its face, in local coordinates.
template <typename View>
struct Star_edge
{
  typename View::Halfedge edge;
  Vec3<typename View::Scalar> source, target, apex;
};

/// The faces around a site in a spider's local coordinates.
template <typename View>
struct Star
{
  Local_coordinates<typename View::Scalar> local;
  boost::container::small_vector<Star_edge<View>, 12> edges;

  Star(const View& view, const Site<View>& site, const Local_coordinates<typename View::Scalar>& coordinates)
    : local(coordinates)
  {
    for(typename View::Halfedge e : site.rim)
      edges.push_back({e, local(view.point(view.source(e))), local(view.point(view.target(e))),
                       local(view.point(view.target(view.other_edges(e).first)))});
  }
};

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_STAR_H
