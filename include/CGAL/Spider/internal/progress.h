// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_INTERNAL_PROGRESS_H
#define CGAL_SPIDER_INTERNAL_PROGRESS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <functional>

namespace CGAL {
namespace Spider {
namespace internal {

/// The visitor of those who didn't give one.
struct Default_visitor
{
  void progress(double) {}
};

/// returns the parameter `visitor`, a copy or what it refers to by `std::ref()`.
template <typename NamedParameters>
auto visitor_of(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::visitor),
                                            Default_visitor());
}

/// tells a visitor the share of the work that is done.
template <typename Visitor>
void tell_progress(Visitor& visitor, double share)
{
  visitor.progress(share);
}

template <typename Visitor>
void tell_progress(std::reference_wrapper<Visitor> visitor, double share)
{
  visitor.get().progress(share);
}

} // namespace internal
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_INTERNAL_PROGRESS_H
