// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPIDER_BENCHMARK_ESTIMATORS_H
#define CGAL_SPIDER_BENCHMARK_ESTIMATORS_H

#include "Estimator.h"

#include "estimators/Corrected_curvatures.h"
#include "estimators/Goldfeather_Interrante_2004.h"
#include "estimators/Jet_fitting.h"
#include "estimators/Meyer_2003.h"
#include "estimators/Normal_cycle_2003.h"
#include "estimators/Rusinkiewicz_2004.h"
#include "estimators/Spider.h"
#include "estimators/Taubin_1995.h"

namespace CGAL {
namespace Spider {
namespace benchmark {

// All estimators under comparison, in the order in which tables list them. To add one: its header in estimators/,
// and its line here.
inline Estimators all_estimators()
{
  Estimators all;
  all.push_back(spider(2));
  all.push_back(spider(4));
  all.push_back(spider_at_suggested_radius());
  all.push_back(spider_at_adaptive_radii());
  all.push_back(std::make_unique<Spider_with_adaptive_limbs>());
  all.push_back(spider_as_published());
  all.push_back(std::make_unique<Jet_fitting>(2, Jet_fitting::Neighbourhood::rings));
  all.push_back(std::make_unique<Jet_fitting>(2, Jet_fitting::Neighbourhood::ball));
  all.push_back(std::make_unique<Jet_fitting>(4, Jet_fitting::Neighbourhood::rings));
  all.push_back(std::make_unique<Jet_fitting>(4, Jet_fitting::Neighbourhood::ball));
  all.push_back(std::make_unique<Meyer_2003>(Meyer_2003::Smoothing::none));
  all.push_back(std::make_unique<Meyer_2003>(Meyer_2003::Smoothing::laplacian));
  all.push_back(std::make_unique<Taubin_1995>());
  all.push_back(std::make_unique<Normal_cycle_2003>());
  all.push_back(std::make_unique<Rusinkiewicz_2004>());
  using Goldfeather = Goldfeather_Interrante_2004;
  all.push_back(std::make_unique<Goldfeather>(Goldfeather::Neighbourhood::one_ring));
  all.push_back(std::make_unique<Goldfeather>(Goldfeather::Neighbourhood::ball));
  all.push_back(std::make_unique<Goldfeather>(Goldfeather::Neighbourhood::ball, Normal_weight::area));
#ifdef CGAL_SPIDER_HAS_CORRECTED_CURVATURES
  using Corrected = Corrected_curvatures;
  all.push_back(std::make_unique<Corrected>(Corrected::Neighbourhood::one_ring, Corrected::Normals::own));
  all.push_back(std::make_unique<Corrected>(Corrected::Neighbourhood::ball, Corrected::Normals::own));
  all.push_back(std::make_unique<Corrected>(Corrected::Neighbourhood::ball, Corrected::Normals::area));
#endif
  return all;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL

#endif // CGAL_SPIDER_BENCHMARK_ESTIMATORS_H
