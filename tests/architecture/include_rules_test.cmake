# SPDX-License-Identifier: BSD-3-Clause
# Proves that include_rules.cmake can fail: plants files that break rules, and some that do not.
# Run as: cmake -DRULES=<include_rules.cmake> -DSCRATCH=<folder> -P include_rules_test.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${SCRATCH})

file(WRITE ${SCRATCH}/haptics/field/planted.cpp "int a[3]; // a \\\n\n#include <QWidget>\n")
file(WRITE ${SCRATCH}/haptics/solver/planted.h "#pragma once\n  #  include \"haptics/proxy/tick.h\"\n")
file(WRITE ${SCRATCH}/haptics/proxy/planted.h "#pragma once\n#include \"haptics/servo/rate.h\"\n")
file(WRITE ${SCRATCH}/haptics/simulation/planted.cpp "#include \"haptics/process/output_file.h\"\n")
file(WRITE ${SCRATCH}/datasets/edits/planted.cpp
     "#include \"haptics/carving/wall.h\"\n#include \"haptics/scene/scene.h\"\n")
file(WRITE ${SCRATCH}/haptics/devices/planted.cpp
     "#include \"haptics/devices/device.h\"\n#include \"haptics/field/isosurface.h\"\n")
file(WRITE ${SCRATCH}/ui/planted.h "#include \"haptics/snapshot.h\"\n#include \"haptics/session.h\"\n")
file(WRITE ${SCRATCH}/datasets/phantoms/planted.cpp "#include <vtkImageData.h>\n")
file(WRITE ${SCRATCH}/datasets/readers/fine.cpp "#include <vtkImageData.h>\n")
file(WRITE ${SCRATCH}/datasets/readers/parsed.cpp "#include <vtkPLYReader.h>\n")
file(WRITE ${SCRATCH}/datasets/readers/planted.cpp "#include \"resources/messages/messages.h\"\n")
file(WRITE ${SCRATCH}/ui/worded.cpp "#include \"resources/messages/messages.h\"\n")
file(WRITE ${SCRATCH}/app/planted.cpp "#include \"haptics/collision/sweep.h\"\n")
file(WRITE ${SCRATCH}/app/driven.cpp
     "#include \"haptics/devices/catalogue.h\"\n#include \"haptics/devices/threaded.h\"\n")
file(WRITE ${SCRATCH}/app/cli/fine.cpp "#include \"haptics/collision/sweep.h\"\n")
file(WRITE ${SCRATCH}/app/cli/planted.cpp "#include \"ui/window/main_window.h\"\n")
file(WRITE ${SCRATCH}/app/study/plan/planted.h "#pragma once\n#include <vtkImageData.h>\n")
file(WRITE ${SCRATCH}/resources/planted.cpp "#include \"app/application.h\"\n")
file(WRITE ${SCRATCH}/app/fetch/fine.cpp "#include <QNetworkReply>\n#include <dcmtk/dcmnet/dimse.h>\n")
file(WRITE ${SCRATCH}/app/fetch/planted.cpp "#include <QNetworkReply>\n#include <QDialog>\n")
file(WRITE ${SCRATCH}/app/window/planted.cpp "#include <QTcpSocket>\n")
file(WRITE ${SCRATCH}/app/cli/studied.cpp "#include \"app/study/studies.h\"\n")
file(WRITE ${SCRATCH}/app/study/program/fine.cpp "#include \"app/study/studies.h\"\n")
file(WRITE ${SCRATCH}/app/log/fine.cpp "#include <spdlog/logger.h>\n")
file(WRITE ${SCRATCH}/haptics/servo/planted.cpp "#include <spdlog/logger.h>\n")
file(WRITE ${SCRATCH}/haptics/tool/planted.cpp "#include \"../core/error.h\"\n")

execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${SCRATCH} -P ${RULES}
                RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE complained)
set(said "${said}${complained}")
set(expected
  "haptics/field/planted.cpp:3:" "haptics/solver/planted.h:2:" "haptics/proxy/planted.h:2:" "haptics/devices/planted.cpp:2:"
  "haptics/simulation/planted.cpp:1:" "datasets/edits/planted.cpp:2:" "ui/planted.h:2:" "datasets/phantoms/planted.cpp:1:"
  "datasets/readers/planted.cpp:1:" "datasets/readers/parsed.cpp:1:" "ui/worded.cpp:1:" "app/planted.cpp:1:" "app/driven.cpp:2:"
  "resources/planted.cpp:1:" "haptics/tool/planted.cpp:1:" "app/cli/planted.cpp:1:"
  "app/study/plan/planted.h:2:"
  "app/fetch/planted.cpp:2:" "app/window/planted.cpp:1:" "app/cli/studied.cpp:1:" "haptics/servo/planted.cpp:1:" "21 includes point")
foreach(violation IN LISTS expected)
  string(FIND "${said}" "${violation}" at)
  if(at EQUAL -1)
    message(SEND_ERROR "The rules missed ${violation}\n${said}")
  endif()
endforeach()
if(status EQUAL 0)
  message(SEND_ERROR "The rules found violations and did not fail.")
endif()
