# Runs the programs on little, makes the report of it, and opens it in a browser.
set(results ${CMAKE_CURRENT_BINARY_DIR}/results)
set(few --quick --no-progress --output ${results})
add_test(NAME compare_accuracy COMMAND compare_accuracy ${few} --vertices 400 --stability --pictures
                                       --estimators spider,jet2,meyer)
add_test(NAME compare_speed COMMAND compare_speed ${few} --estimators spider,jet2,meyer)
set_tests_properties(compare_accuracy compare_speed PROPERTIES FIXTURES_SETUP spider_results TIMEOUT 300)

if(SPIDER_DATA_ARCHIVE)
  add_test(NAME compare_on_scan COMMAND compare_on_scan ${few} --estimators jet2,meyer ${SPIDER_DATA_DIR}/bones.off)
  set_tests_properties(compare_on_scan PROPERTIES FIXTURES_SETUP spider_results TIMEOUT 300)
  add_dependencies(compare_on_scan spider_data)

  # not in the report, which is of curvature
  add_test(NAME compare_smoothing COMMAND compare_smoothing ${few} ${SPIDER_DATA_DIR}/hand.off)
  set_tests_properties(compare_smoothing PROPERTIES PASS_REGULAR_EXPRESSION "\nrings  +0\\.200 +0\\.[0-9]+ .* 0\\.000 "
                                                    TIMEOUT 300)
  add_dependencies(compare_smoothing spider_data)
endif()

# Debian's own Python, whose packages the report needs, rather than another that comes first on the path
find_program(SPIDER_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(SPIDER_XVFB_RUN xvfb-run)
execute_process(COMMAND ${SPIDER_PYTHON} -c "import jinja2, matplotlib, vtk" RESULT_VARIABLE spider_python_lacks
                OUTPUT_QUIET ERROR_QUIET)
if(NOT SPIDER_DATA_ARCHIVE OR NOT SPIDER_XVFB_RUN OR NOT "${spider_python_lacks}" STREQUAL "0")
  message(STATUS "The report isn't tested: that takes libcgal-demo, python3-jinja2, python3-matplotlib, python3-vtk9, "
                 "and xvfb")
  return()
endif()
add_test(NAME report COMMAND ${SPIDER_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/check_report.py
                             ${CMAKE_CURRENT_SOURCE_DIR}/../report ${results})
set_tests_properties(report PROPERTIES FIXTURES_REQUIRED spider_results FIXTURES_SETUP spider_report TIMEOUT 300)

add_test(NAME report_in_browser COMMAND ${SPIDER_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/check_report_in_browser.py
                                        ${results}/report.html)
set_tests_properties(report_in_browser PROPERTIES FIXTURES_REQUIRED spider_report TIMEOUT 300 SKIP_RETURN_CODE 77)
