# The program spider as its user has it: on a file of every format, and its words and exit codes about what it refuses.
# What it writes is tested by test_tool_program.cpp.
target_compile_definitions(spider_tests PRIVATE SPIDER_TOOL="$<TARGET_FILE:spider_tool>")
add_dependencies(spider_tests spider_tool)

# spider_add_tool_test(name mesh expected-output [option...]): the program succeeds and says what is expected.
function(spider_add_tool_test name mesh expected)
  add_test(NAME tool_${name} COMMAND spider_tool ${SPIDER_DATA_DIR}/${mesh} ${ARGN})
  set_tests_properties(tool_${name} PROPERTIES PASS_REGULAR_EXPRESSION "${expected}" TIMEOUT 60)
endfunction()

if(SPIDER_DATA_ARCHIVE)
  # Four edges, the default radius, are more than the radius of this sphere.
  spider_add_tool_test(reads_off sphere.off "vertices ok +162" --radius-in-edges 2)
  spider_add_tool_test(reads_stl sphere.stl "vertices ok +162" --radius-in-edges 2)
  spider_add_tool_test(reads_ply sphere.ply "vertices ok +162" --radius-in-edges 2)
  spider_add_tool_test(reaches_less_than_a_large_radius sphere.off "partial +162")
  spider_add_tool_test(separates_touching_parts pig.stl "16848 triangles.*vertices ok +[1-9]")
  spider_add_tool_test(triangulates cube_quad.off "8 vertices, 12 triangles")
  spider_add_tool_test(compares_with_jets sphere966.off "Spider +jets, d = 2.*their correlation is" --compare-with-jets)
endif()

add_test(NAME tool_teaches COMMAND spider_tool --help)
set_tests_properties(tool_teaches PROPERTIES PASS_REGULAR_EXPRESSION "--suggest-radius.*Examples:.*Exit status:")

# A picture takes Python's VTK, and a display, which may be virtual.
if(SPIDER_DATA_ARCHIVE)
  add_test(NAME tool_renders COMMAND spider_tool ${SPIDER_DATA_DIR}/sphere966.off --picture
                                     ${CMAKE_CURRENT_BINARY_DIR}/sphere.png)
  set_tests_properties(tool_renders PROPERTIES TIMEOUT 60 PASS_REGULAR_EXPRESSION
                                                          "written: .*sphere.png" SKIP_REGULAR_EXPRESSION
                                                          "spider-picture: there is no")
endif()

# With the library installed, so is the program, and it finds what it needs.
add_test(NAME tool_is_installed COMMAND ${CMAKE_CURRENT_BINARY_DIR}/consumer/prefix/bin/spider --version)
set_tests_properties(tool_is_installed PROPERTIES FIXTURES_REQUIRED spider_installed PASS_REGULAR_EXPRESSION
                                                  "^spider ${PROJECT_VERSION}")
