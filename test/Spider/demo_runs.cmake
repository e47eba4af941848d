# The demo program as its user has it: on a file of every format, and on what it must refuse with one line and exit code 1.
set(demo_dir ${CMAKE_CURRENT_BINARY_DIR}/demo)
file(MAKE_DIRECTORY ${demo_dir})

# spider_add_demo_test(name mesh expected-output [option...]): the program succeeds and says what is expected.
function(spider_add_demo_test name mesh expected)
  add_test(NAME demo_${name} COMMAND spider_demo ${SPIDER_DATA_DIR}/${mesh} --output ${demo_dir}/${name}.ply ${ARGN})
  set_tests_properties(demo_${name} PROPERTIES PASS_REGULAR_EXPRESSION "${expected}" TIMEOUT 60)
endfunction()

if(SPIDER_DATA_ARCHIVE)
  # Four edges, the default radius, are more than the radius of this sphere.
  spider_add_demo_test(reads_off sphere.off "vertices ok +162" --radius-in-edges 2)
  spider_add_demo_test(reads_stl sphere.stl "vertices ok +162" --radius-in-edges 2)
  spider_add_demo_test(reads_ply sphere.ply "vertices ok +162" --radius-in-edges 2)
  spider_add_demo_test(reaches_less_than_a_large_radius sphere.off "partial +162")
  spider_add_demo_test(separates_touching_parts pig.stl "16848 triangles.*vertices ok +[1-9]")
  spider_add_demo_test(triangulates cube_quad.off "8 vertices, 12 triangles")
endif()
