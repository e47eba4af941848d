# A consumer's project configures, builds and runs against an installed Spider, and against Spider's sources.
set(prefix ${CMAKE_CURRENT_BINARY_DIR}/consumer/prefix)

add_test(NAME consumer_install COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${prefix})
set_tests_properties(consumer_install PROPERTIES FIXTURES_SETUP spider_installed)

# spider_add_consumer_test(name option...): the options tell the consumer's CMake where Spider is.
function(spider_add_consumer_test name)
  add_test(
    NAME ${name}
    COMMAND
      ${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer
      ${CMAKE_CURRENT_BINARY_DIR}/consumer/${name} --build-generator ${CMAKE_GENERATOR} --build-options
      -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCGAL_DIR=${CGAL_DIR} ${ARGN}
      --test-command consumer)
  set_tests_properties(${name} PROPERTIES TIMEOUT 300)
endfunction()

spider_add_consumer_test(consumer_find_package -DCMAKE_PREFIX_PATH=${prefix})
set_tests_properties(consumer_find_package PROPERTIES FIXTURES_REQUIRED spider_installed)
spider_add_consumer_test(consumer_add_subdirectory -DSPIDER_SOURCE_DIR=${PROJECT_SOURCE_DIR})
