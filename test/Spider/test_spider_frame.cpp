// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "estimation.h"

#include <CGAL/Spider/internal/Spider_frame.h>

using namespace estimation;

TEST(Spider_frame, is_orthonormal_and_right_handed_however_near_the_reference_is_to_the_normal)
{
  // Where the reference is the normal, rounding leaves nothing of the first of these, and of the second a bit of itself.
  for(const Vector& direction : {Vector(0.3, -0.5, 0.8), Vector(1, -1, 0)})
    for(double tilt : {1., 1e-3, 1e-9, 1e-13, 1e-15, 0.})
    {
      SCOPED_TRACE(tilt);
      const Vector normal = direction.normalized(), aside = normal.cross(Vector::UnitX()).normalized();
      const Spider::internal::Spider_frame<double> frame(normal, 7 * (normal + tilt * aside));
      Eigen::Matrix3d axes;
      axes << frame.tangent, frame.bitangent, frame.normal;
      EXPECT_TRUE((axes.transpose() * axes).isIdentity(4e-15)) << axes;
      EXPECT_NEAR(axes.determinant(), 1, 4e-15);
      if(tilt >= 1e-3)
      {
        EXPECT_LE((frame.tangent - aside).norm(), 1e-12);
      }
    }
}
