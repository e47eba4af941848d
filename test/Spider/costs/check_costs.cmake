# Compares the instructions that spider_costs takes for some work with what is allowed: `measured` per vertex and `margin`
# percent more, or `most_percent` of those for some other work.
function(count_instructions work result)
  execute_process(
    COMMAND ${valgrind} --tool=callgrind --toggle-collect=spider_measured --callgrind-out-file=/dev/null ${program} ${work}
    OUTPUT_VARIABLE output
    ERROR_VARIABLE output
    RESULT_VARIABLE status)
  if(NOT status EQUAL 0 OR NOT output MATCHES "vertices: ([0-9]+)")
    message(FATAL_ERROR "valgrind couldn't run ${program} ${work}:\n${output}")
  endif()
  set(vertices ${CMAKE_MATCH_1})
  string(REGEX MATCH "Collected : ([0-9]+)" collected "${output}")
  math(EXPR count "${CMAKE_MATCH_1} / ${vertices}")
  message(STATUS "${work}: ${count} instructions per vertex")
  set(${result} ${count} PARENT_SCOPE)
endfunction()

count_instructions(${work} count)
if(DEFINED other_work)
  count_instructions(${other_work} other_count)
  math(EXPR most "${other_count} * ${most_percent} / 100")
else()
  math(EXPR most "${measured} * (100 + ${margin}) / 100")
  math(EXPR least "${measured} * (100 - ${margin}) / 100")
  if(count LESS least)
    message(STATUS "That is so much less than ${measured} that a lower figure can be written beside it")
  endif()
endif()
if(count GREATER most)
  message(FATAL_ERROR "These are more than the ${most} that are allowed")
endif()
