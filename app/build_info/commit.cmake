# SPDX-License-Identifier: BSD-3-Clause
# Writes the commit of the sources into a source file, if it is another than before:
# cmake -DSOURCE=… -DFILE=… [-DCOMMIT=…] -P commit.cmake
if(NOT COMMIT)
  find_program(git git)
  if(git AND EXISTS ${SOURCE}/.git)
    execute_process(COMMAND ${git} rev-parse --short=12 HEAD WORKING_DIRECTORY ${SOURCE}
      OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND ${git} diff --quiet HEAD -- WORKING_DIRECTORY ${SOURCE}
      RESULT_VARIABLE changed OUTPUT_QUIET ERROR_QUIET)
    if(COMMIT AND changed)
      string(APPEND COMMIT "-changed")
    endif()
  endif()
  if(NOT COMMIT)
    set(COMMIT unknown)
  endif()
endif()
set(text "namespace app {\nextern const char* const kCommit;\nconst char* const kCommit = \"${COMMIT}\";\n}  // namespace app\n")
set(before)
if(EXISTS ${FILE})
  file(READ ${FILE} before)
endif()
if(NOT before STREQUAL text)
  file(WRITE ${FILE} "${text}")
endif()
