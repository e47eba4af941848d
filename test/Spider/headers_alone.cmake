# Every header, public and internal, must compile without another one before it. They are built with the tests, of
# generated sources that include nothing else: an object file per header, but for those that another header includes
# first of all, since they have nothing before them there either.
set(include_dir ${PROJECT_SOURCE_DIR}/include)
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${include_dir} ${include_dir}/CGAL/*.h)
set(headers_to_compile ${headers})
foreach(header IN LISTS headers)
  file(STRINGS ${include_dir}/${header} includes REGEX "^ *# *include" LIMIT_COUNT 1)
  if(includes MATCHES "<(CGAL/Spider/.+)>")
    list(REMOVE_ITEM headers_to_compile ${CMAKE_MATCH_1})
  endif()
endforeach()

add_library(spider_headers_alone OBJECT)
target_link_libraries(spider_headers_alone PRIVATE spider_strict)
# Nobody runs these, so nothing is spent on making them fast or debuggable.
target_compile_options(spider_headers_alone PRIVATE -O0 -g0)

foreach(header IN LISTS headers_to_compile)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${header}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "#include <@header@>\n" @ONLY)
  target_sources(spider_headers_alone PRIVATE ${source})
endforeach()
