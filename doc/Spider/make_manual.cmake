# Runs Doxygen anew, and fails with its warnings where it has any. The directory FIGURES goes with the pages.
file(REMOVE_RECURSE ${MANUAL})
file(MAKE_DIRECTORY ${MANUAL})
set(log ${MANUAL}/warnings.log)
execute_process(COMMAND ${DOXYGEN} ${DOXYFILE} RESULT_VARIABLE failed)
set(warnings "")
if(EXISTS ${log})
  file(READ ${log} warnings)
  file(REMOVE ${log})
endif()
if(failed OR warnings)
  message(FATAL_ERROR "Doxygen has warnings:\n${warnings}")
endif()
file(COPY ${FIGURES} DESTINATION ${MANUAL}) # for what pages link to there
