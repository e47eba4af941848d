# Finds what Spider stands on, for its own build and for its installed package alike: CGAL, Eigen and, where there is
# one, TBB. Spider_missing is empty afterwards, or a sentence that says what is missing and how to get it.
# CGAL_DISABLE_GMP and the like stay the user's own choice: nothing is set here that CGAL would ask about.
set(Spider_missing "")

# The oldest version is compared here, since CGAL's version file takes "5.5" to exclude 6. CGAL's unpacked sources have no
# version file; whoever points at them is taken to know what they are.
find_package(CGAL QUIET)
if(NOT CGAL_FOUND)
  set(Spider_missing "Spider needs CGAL 5.5 or later, and there is none (Debian and Ubuntu: libcgal-dev).")
  return()
elseif(CGAL_VERSION AND CGAL_VERSION VERSION_LESS 5.5)
  set(Spider_missing "Spider needs CGAL 5.5 or later, and found ${CGAL_VERSION} in ${CGAL_DIR}.")
  return()
endif()

# Without a version, since CGAL's support module compares only major versions, and CGAL 5.5 knows of Eigen 3 alone.
find_package(Eigen3 QUIET)
include(CGAL_Eigen3_support)
if(NOT TARGET CGAL::Eigen3_support)
  set(Spider_missing "Spider needs Eigen 3.3 or later (Debian and Ubuntu: libeigen3-dev).")
  return()
endif()

find_package(TBB QUIET)
include(CGAL_TBB_support)
