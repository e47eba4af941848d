// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry.h"
#include "estimators.h"

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <ctime>
#include <set>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

std::set<std::string> matching_names(const Estimators& estimators, const std::string& wanted)
{
  std::set<std::string> matching;
  std::string known;
  for(const auto& estimator : estimators)
  {
    const std::string name = estimator->name();
    if(name == wanted)
      return {name};
    if(boost::algorithm::icontains(name, wanted))
      matching.insert(name);
    known += known.empty() ? name : ", " + name;
  }
  if(matching.empty())
    throw std::invalid_argument("no estimator is called \"" + wanted + "\"; there are: " + known);
  return matching;
}

} // namespace

Estimators select_estimators(const std::vector<std::string>& names)
{
  Estimators all = all_estimators();
  if(names.empty())
    return all;
  std::set<std::string> selected;
  for(const std::string& name : names)
    selected.merge(matching_names(all, name));

  Estimators result;
  for(auto& estimator : all)
    if(selected.count(estimator->name()) > 0)
      result.push_back(std::move(estimator));
  return result;
}

Timed_estimates run(const Estimator& estimator, const Mesh& mesh, double radius)
{
  Timed_estimates result;
  const std::clock_t begin = std::clock();
  estimator.estimate(mesh, radius, result.estimates);
  result.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return result;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
