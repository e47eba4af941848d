# Every header, public and internal, must compile without another one before it. They are built with the tests: an
# object file per header, of a generated source that includes nothing else.
set(include_dir ${PROJECT_SOURCE_DIR}/include)
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${include_dir} ${include_dir}/CGAL/*.h)

add_library(spider_headers_alone OBJECT)
target_link_libraries(spider_headers_alone PRIVATE spider_strict)
# Nobody runs these, so nothing is spent on making them fast or debuggable.
target_compile_options(spider_headers_alone PRIVATE -O0 -g0)

foreach(header IN LISTS headers)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${header}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "#include <@header@>\n" @ONLY)
  target_sources(spider_headers_alone PRIVATE ${source})
endforeach()
