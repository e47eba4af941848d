# The interface target Spider::Spider: the headers, and what they stand on.
include(Spider_dependencies)
if(Spider_missing)
  message(FATAL_ERROR "${Spider_missing}")
endif()

add_library(Spider INTERFACE)
add_library(Spider::Spider ALIAS Spider)
target_compile_features(Spider INTERFACE cxx_std_17)
target_include_directories(Spider INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                            $<INSTALL_INTERFACE:include>)
target_link_libraries(Spider INTERFACE CGAL::CGAL CGAL::Eigen3_support)

# An installed Spider uses TBB where its user has it, whether or not there was one when Spider was installed.
if(TARGET CGAL::TBB_support)
  target_link_libraries(Spider INTERFACE $<BUILD_INTERFACE:CGAL::TBB_support>)
endif()
target_link_libraries(Spider INTERFACE $<INSTALL_INTERFACE:$<TARGET_NAME_IF_EXISTS:CGAL::TBB_support>>)
