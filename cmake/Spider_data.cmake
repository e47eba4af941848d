# The meshes that come with CGAL, for the tests, the examples, the tool and the benchmarks: the target spider_data
# unpacks them once into the build tree. CGAL_DATA_DIR is the directory that CGAL::data_file_path knows by that name,
# SPIDER_DATA_DIR the one with the meshes. Without the archive there is no such directory, and who needs a mesh skips.
find_file(SPIDER_DATA_ARCHIVE libcgal-dev/data.tar.gz PATHS /usr/share/doc
          DOC "CGAL's example data, with the meshes under data/meshes (Debian and Ubuntu: libcgal-demo)")

set(spider_data_root ${PROJECT_BINARY_DIR}/cgal-data)
set(CGAL_DATA_DIR ${spider_data_root}/data)
set(SPIDER_DATA_DIR ${CGAL_DATA_DIR}/meshes)

if(SPIDER_DATA_ARCHIVE)
  set(spider_data_stamp ${spider_data_root}/unpacked)
  file(MAKE_DIRECTORY ${spider_data_root})
  add_custom_command(
    OUTPUT ${spider_data_stamp}
    COMMAND ${CMAKE_COMMAND} -E tar xzf ${SPIDER_DATA_ARCHIVE} data/meshes
    COMMAND ${CMAKE_COMMAND} -E touch ${spider_data_stamp}
    DEPENDS ${SPIDER_DATA_ARCHIVE}
    WORKING_DIRECTORY ${spider_data_root}
    COMMENT "Unpacking CGAL's meshes"
    VERBATIM)
  add_custom_target(spider_data DEPENDS ${spider_data_stamp})
else()
  message(STATUS "No SPIDER_DATA_ARCHIVE (Debian and Ubuntu: libcgal-demo): tests that need CGAL's meshes will skip")
  add_custom_target(spider_data)
endif()
