# SPDX-License-Identifier: GPL-3.0-or-later
# Fails where the program or one of its libraries defines a symbol of somebody else's library, which
# would then serve every other library of the process too, or where the program needs a BLAS, which
# may start threads of its own or serve one caller at a time.
#   cmake -DNM=nm -DPROGRAM=... -DLIBRARIES=a.a;b.a -P symbols_test.cmake
cmake_minimum_required(VERSION 3.25)

set(FOREIGN "GOMP_.*|GOACC_.*|omp_.*|SuiteSparse_.*|cholmod_.*|amd_.*|cblas_.*|openblas_.*|LAPACKE_.*")
set(BLAS_OR_LAPACK "[sdczi][a-z0-9]+_|xerbla_") # as Fortran names them
set(COMPLAINTS "")

foreach(file IN LISTS PROGRAM LIBRARIES)
  execute_process(COMMAND ${NM} --defined-only --extern-only --format=posix ${file}
                  OUTPUT_VARIABLE symbols ERROR_QUIET RESULT_VARIABLE status)
  if(status)
    string(APPEND COMPLAINTS "\n  ${file}: ${NM} cannot read it")
    continue()
  endif()
  string(REGEX MATCHALL "[^\n]+" lines "${symbols}")
  foreach(line IN LISTS lines)
    if(line MATCHES "^(${FOREIGN}|${BLAS_OR_LAPACK}) [A-Za-z]")
      string(APPEND COMPLAINTS "\n  ${file} defines ${CMAKE_MATCH_1}")
    endif()
  endforeach()
endforeach()

if(PROGRAM)
  execute_process(COMMAND ldd ${PROGRAM} OUTPUT_VARIABLE needed)
  string(REGEX MATCHALL "lib[a-z_]*(blas|lapack|gomp|omp|cholmod|mkl)[^ ]*" found "${needed}")
  foreach(library IN LISTS found)
    string(APPEND COMPLAINTS "\n  ${PROGRAM} needs ${library}")
  endforeach()
endif()

if(COMPLAINTS)
  message(FATAL_ERROR "Symbols and libraries of others:${COMPLAINTS}")
endif()
