# What Spider's own programs are held to, as an interface target: Spider's promises stay free of it.
add_library(spider_strict INTERFACE)
target_link_libraries(spider_strict INTERFACE Spider::Spider)
target_compile_options(spider_strict INTERFACE -Wall -Wextra $<$<BOOL:${SPIDER_WARNINGS_AS_ERRORS}>:-Werror>)

# spider_add_program(name source...): one of Spider's own programs.
function(spider_add_program name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE spider_strict)
endfunction()
