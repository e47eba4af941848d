# The paper's figures: cmake --build <directory> --target spider_figures makes doc/Spider/paper_figures.md and its pictures anew.
spider_add_program(
  paper_figures
  Figure.cpp
  figure_estimates.cpp
  figure_of_smoothing.cpp
  figures_of_scans.cpp
  figures_of_spiders.cpp
  figures_of_surfaces.cpp
  figures_of_the_cube.cpp
  paper_figures.cpp)
target_link_libraries(paper_figures PRIVATE spider_benchmark_surfaces nlohmann_json::nlohmann_json CLI11::CLI11)

execute_process(COMMAND ${SPIDER_PYTHON} -c "import matplotlib, numpy, vtk" RESULT_VARIABLE spider_python_lacks
                OUTPUT_QUIET ERROR_QUIET)
if(NOT SPIDER_DATA_ARCHIVE OR NOT SPIDER_XVFB_RUN OR NOT SPIDER_PNGQUANT OR NOT "${spider_python_lacks}" STREQUAL "0")
  message(STATUS "No target spider_figures: that takes libcgal-demo, python3-vtk9, python3-matplotlib, xvfb and pngquant")
  return()
endif()

set(figures ${CMAKE_CURRENT_BINARY_DIR}/paper)
set(figure_pictures)
foreach(number RANGE 1 11)
  list(APPEND figure_pictures ${figures}/figure_${number}.png)
endforeach()
add_custom_target(
  spider_figures
  COMMAND paper_figures ${SPIDER_DATA_DIR} ${figures}
  COMMAND ${SPIDER_XVFB_RUN} --auto-servernum ${SPIDER_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/render_figures.py ${figures}
  # without dithering, whose grain doesn't compress
  COMMAND ${SPIDER_PNGQUANT} --force --strip --nofs --speed 1 192 --ext=.png ${figure_pictures}
  COMMAND ${CMAKE_COMMAND} -E copy ${figure_pictures} ${PROJECT_SOURCE_DIR}/doc/Spider/fig
  COMMAND ${SPIDER_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/make_page.py
          ${PROJECT_SOURCE_DIR}/doc/Spider/paper_figures.md --data ${figures}
  VERBATIM)
add_dependencies(spider_figures spider_data)

if(SPIDER_BUILD_TESTS)
  add_test(NAME paper_figures_page COMMAND ${SPIDER_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/make_page.py
                                           ${PROJECT_SOURCE_DIR}/doc/Spider/paper_figures.md)
  # those that take seconds
  add_test(NAME paper_figures_compute COMMAND paper_figures ${SPIDER_DATA_DIR} ${figures}-test 1 2 4 11)
  add_test(NAME paper_figures_render COMMAND ${SPIDER_XVFB_RUN} --auto-servernum ${SPIDER_PYTHON}
                                             ${CMAKE_CURRENT_SOURCE_DIR}/render_figures.py ${figures}-test 1 2 4 11)
  set_tests_properties(paper_figures_compute PROPERTIES FIXTURES_SETUP paper_figures TIMEOUT 120)
  set_tests_properties(paper_figures_render PROPERTIES FIXTURES_REQUIRED paper_figures TIMEOUT 120)
endif()
