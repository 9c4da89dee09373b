# SPDX-License-Identifier: BSD-3-Clause
# Who may include whom. Run as: cmake -DROOT=<tree> -P include_rules.cmake
# Prints every violation as file:line and fails if there is one.
cmake_minimum_required(VERSION 3.25)

set(rule_count 0)
# rule(FOLDERS regex FORBIDS regex [EXCEPT regex] [PERMITS regex] WHY words): files in FOLDERS, less
# those in EXCEPT, include nothing that FORBIDS matches, save what PERMITS matches
macro(rule)
  cmake_parse_arguments(rule_${rule_count} "" "FOLDERS;EXCEPT;FORBIDS;PERMITS;WHY" "" ${ARGN})
  math(EXPR rule_count "${rule_count} + 1")
endmacro()

rule(FOLDERS "haptics" FORBIDS "^(Q[A-Za-z]|vtk|ui/|app/|datasets/|resources/)"
     WHY "haptics knows neither window nor picture")
rule(FOLDERS "haptics/(core|field|tool|collision|solver|coupling)"
     FORBIDS "^haptics/(proxy|servo|devices|simulation|session)"
     WHY "the algorithm knows neither proxy nor threads nor devices")
rule(FOLDERS "haptics/(scene|proxy)" FORBIDS "^haptics/(servo|devices|simulation|session)"
     WHY "the proxy knows neither threads nor devices")
rule(FOLDERS "haptics" EXCEPT "haptics/process" FORBIDS "^(haptics/process/|sqlite3)" WHY "the touch has no files")
rule(FOLDERS "haptics/core" FORBIDS "^haptics/" PERMITS "^haptics/core/"
     WHY "the common words depend on nothing")
rule(FOLDERS "haptics/process" FORBIDS "^haptics/" PERMITS "^haptics/(core|process)/"
     WHY "files and limits know the common words alone")
rule(FOLDERS "haptics/carving" FORBIDS "^haptics/" PERMITS "^haptics/(core|carving)/"
     WHY "what lowers voxels knows the common words alone")
rule(FOLDERS "haptics/structures" FORBIDS "^haptics/" PERMITS "^haptics/(core|structures)/"
     WHY "distances know the common words alone")
rule(FOLDERS "haptics/devices" FORBIDS "^haptics/"
     PERMITS "^haptics/((core|devices)/|settings[.]h$)"
     WHY "a driver sees its interface and the common words")
rule(FOLDERS "ui" FORBIDS "^(haptics/|datasets/|app/|resources/messages/)"
     PERMITS "^haptics/(snapshot[.]h|settings[.]h|core/)"
     WHY "the window is told; it opens nothing")
rule(FOLDERS "datasets" FORBIDS "^(Q[A-Za-z]|ui/|app/|haptics/|resources/)" PERMITS "^haptics/(core|process|carving|structures)/"
     WHY "datasets make volumes, and know of haptics only the words")
rule(FOLDERS "datasets/phantoms" FORBIDS "^vtk" WHY "phantoms build without VTK")
rule(FOLDERS "resources" FORBIDS "^(Q[A-Za-z]|vtk|ui/|app/|datasets/|haptics/)"
     PERMITS "^haptics/core/" WHY "resources are read by all")
rule(FOLDERS "app" EXCEPT "app/(study|cli|measurement|recording)"
     FORBIDS "^haptics/(field|collision|solver|coupling|proxy|servo|devices)/"
     PERMITS "^haptics/(devices/(catalogue|combined)|servo/emergency|field/lanes|proxy/cutting)[.]h$"
     WHY "the application uses haptics through its root headers")
rule(FOLDERS "app/(study|cli|measurement|page|report)" FORBIDS "^(Q[A-Za-z]|vtk|ui/)"
     WHY "the command line, the studies and the reports build without Qt and VTK")
rule(FOLDERS "app" EXCEPT "app/study" FORBIDS "^app/study/" WHY "studies are a program of their own")
rule(FOLDERS "app/fetch" FORBIDS "^(vtk|ui/|datasets/|QtWidgets|Q(Widget|Application|Dialog)$)"
     WHY "palpate-fetch has neither window nor readers")
rule(FOLDERS "(haptics|ui|datasets|resources|app)" EXCEPT "app/fetch"
     FORBIDS "^(Q(Network|Tcp|Udp|Ssl|Local(Socket|Server))|dcmtk/(dcmnet|dcmtls)/)"
     WHY "palpate-fetch alone speaks to a network")
rule(FOLDERS "(haptics|ui|datasets|resources|app)" EXCEPT "app/log" FORBIDS "^(spdlog|fmt)/"
     WHY "a line of the log is made in app/log, which the servo thread and patient text do not reach")
rule(FOLDERS "(haptics|ui|datasets|resources|app)" FORBIDS "^vtk(PLY|OBJ|STL)Reader"
     WHY "datasets/readers/meshes alone reads a mesh, so that no other parser sees the file")
rule(FOLDERS "(haptics|ui|datasets|resources|app)" FORBIDS "^[.][.]/"
     WHY "an include names its path from the root, so that these rules can read it")

set(violations "")
file(GLOB_RECURSE files RELATIVE ${ROOT}
     ${ROOT}/app/*.h ${ROOT}/app/*.cpp ${ROOT}/datasets/*.h ${ROOT}/datasets/*.cpp
     ${ROOT}/haptics/*.h ${ROOT}/haptics/*.cpp ${ROOT}/resources/*.h ${ROOT}/resources/*.cpp
     ${ROOT}/resources/*.cpp.in ${ROOT}/ui/*.h ${ROOT}/ui/*.cpp)
list(LENGTH files file_count)
if(file_count LESS 4)
  message(FATAL_ERROR "Only ${file_count} source files under '${ROOT}': nothing was checked.")
endif()

foreach(file IN LISTS files)
  file(READ ${ROOT}/${file} text)
  string(REGEX REPLACE "[][;\\]" " " text "${text}") # what a CMake list would trip over
  string(REPLACE "\n" ";" lines "${text}")
  set(number 0)
  foreach(line IN LISTS lines)
    math(EXPR number "${number} + 1")
    if(NOT line MATCHES "^[ \t]*#[ \t]*include[ \t]*[<\"]([^>\"]+)[>\"]")
      continue()
    endif()
    set(included "${CMAKE_MATCH_1}")
    math(EXPR last "${rule_count} - 1")
    foreach(r RANGE ${last})
      if(NOT file MATCHES "^(${rule_${r}_FOLDERS})/" OR NOT included MATCHES "${rule_${r}_FORBIDS}")
        continue()
      endif()
      if(rule_${r}_EXCEPT AND file MATCHES "^(${rule_${r}_EXCEPT})/")
        continue()
      endif()
      if(rule_${r}_PERMITS AND included MATCHES "${rule_${r}_PERMITS}")
        continue()
      endif()
      list(APPEND violations "${file}:${number}: includes ${included}, but ${rule_${r}_WHY}")
    endforeach()
  endforeach()
endforeach()

if(violations)
  list(LENGTH violations count)
  list(JOIN violations "\n" text)
  message("${text}")
  message(FATAL_ERROR "${count} includes point the wrong way.")
endif()
message("${file_count} files, ${rule_count} rules: every include points the right way.")
