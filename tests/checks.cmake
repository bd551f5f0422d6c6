# SPDX-License-Identifier: GPL-3.0-or-later
# Checks of the whole: pages, sweeps, what is installed and linked.

find_package(Python3 REQUIRED COMPONENTS Interpreter)
if(NOT FOLDLESS_SANITIZE)
  include(source_checks.cmake) # they find the same in every build
  add_test(NAME Pages.TablesHaveTheColumnsRowsAndVersionThatBenchWrites
           COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/docs/tables.py ${PROJECT_SOURCE_DIR}
                   $<TARGET_FILE:foldless>)
  add_test(NAME Pages.CommandsOfReadmeWorkAsPasted
           COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/docs/pages.py ${PROJECT_SOURCE_DIR}
                   --paste $<TARGET_FILE:foldless>)
  add_test(NAME Pages.TellEveryKeyAndColumnThatIsWritten
           COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/docs/pages.py ${PROJECT_SOURCE_DIR}
                   --contract $<TARGET_FILE:foldless>)
endif()

add_test(NAME HandlesBenchmark.CheckerTellsOfEachRuleThatIsBroken
         COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/benchmark/check_test.py)
if(NOT FOLDLESS_SANITIZE)
  add_test(NAME HandlesBenchmark.ScenesAreThoseOfTheGeneratorAndFoldlessReachesThem
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/benchmark/scenes_test.sh ${PROJECT_SOURCE_DIR}
                   $<TARGET_FILE_DIR:foldless>)
endif()

# Sweeps over processes. What makes them need not be installed.
function(sweep_test name mode)
  add_test(NAME SweepInShards.${name}
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/sweep/sweep_test.sh ${mode} ${PROJECT_SOURCE_DIR}
                   $<TARGET_FILE_DIR:foldless>)
  set_tests_properties(SweepInShards.${name} PROPERTIES TIMEOUT 300 SKIP_RETURN_CODE 77)
endfunction()
if(NOT FOLDLESS_SANITIZE)
  sweep_test(Of256ScenesTwoOfWhichWereKilledIsThatOfOneRun killed)
  sweep_test(OfGnuParallelIsThatOfOneRun parallel)
  sweep_test(OfASlurmArrayIsThatOfOneRun slurm)
endif()

add_test(NAME Install.GivesAProgramThatFindsItsData
         COMMAND ${CMAKE_COMMAND} -DBUILD_DIR=${PROJECT_BINARY_DIR}
                 -DPREFIX=${CMAKE_CURRENT_BINARY_DIR}/installed
                 -P ${CMAKE_CURRENT_SOURCE_DIR}/install_test.cmake)

if(TARGET foldless_words)
  list(JOIN CPACK_COMPONENTS_ALL "," components)
  add_test(NAME Install.HasEveryFileInOneComponent
           COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                   -DBUILD_DIR=${PROJECT_BINARY_DIR} -DPYTHON=${FOLDLESS_PYTHON3}
                   -DCOMPONENTS=${components},documentation
                   -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/components
                   -P ${CMAKE_CURRENT_SOURCE_DIR}/components_test.cmake)
  add_test(NAME WordsOfHelp.AreAManualPageAndACompletion
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/words_of_help_test.sh
                   ${PROJECT_BINARY_DIR}/words)
endif()

if(NOT FOLDLESS_SANITIZE)
  add_test(NAME Package.IsFoundAndLeavesOthersAsTheyAre
           COMMAND ${CMAKE_COMMAND} -DBUILD_DIR=${PROJECT_BINARY_DIR}
                   -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DCXX=${CMAKE_CXX_COMPILER}
                   -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/package
                   -P ${CMAKE_CURRENT_SOURCE_DIR}/package_test.cmake)
  add_test(NAME Package.DefinesNoSymbolOfOthers
           COMMAND ${CMAKE_COMMAND} -DLIBRARY=$<TARGET_FILE:foldless_core>
                   -P ${CMAKE_CURRENT_SOURCE_DIR}/library_symbols_test.cmake)
endif()

if(TARGET foldless_python)
  add_test(NAME Python.PackageDoesWhatItsTestsSay
           COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/app/python/foldless_test.py)
  set(python_environment PYTHONPATH=${PROJECT_BINARY_DIR}/python PYTHONDONTWRITEBYTECODE=1)
  set_tests_properties(Python.PackageDoesWhatItsTestsSay PROPERTIES
    TIMEOUT 120 ENVIRONMENT "${python_environment}")
  add_test(NAME Python.WheelSolvesAndDrawsWithWhatIsInIt
           COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/app/python/wheel_test.py
                   ${PROJECT_BINARY_DIR})
  execute_process(COMMAND ${Python3_EXECUTABLE} -c "import matplotlib"
                  RESULT_VARIABLE no_matplotlib OUTPUT_QUIET ERROR_QUIET)
  if(no_matplotlib EQUAL 0)
    add_test(NAME Python.ExamplePlots
             COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/app/python/examples/plot.py
                     ${CMAKE_CURRENT_BINARY_DIR}/plot.png)
    set_tests_properties(Python.ExamplePlots PROPERTIES ENVIRONMENT "${python_environment}")
  endif()
endif()

if(DPKG_QUERY AND NOT FOLDLESS_SANITIZE)
  add_test(NAME Sbom.NamesWhatIsLinkedAndWhatIsCompiledIn
           COMMAND ${PROJECT_SOURCE_DIR}/scripts/sbom $<TARGET_FILE:foldless>)
  set_tests_properties(Sbom.NamesWhatIsLinkedAndWhatIsCompiledIn PROPERTIES
    PASS_REGULAR_EXPRESSION
    "pkg:deb/debian/libamd2@.*pkg:deb/debian/libeigen3-dev@.*pkg:deb/debian/libosmesa6@")
endif()

# Sanitizers come with a runtime of their own.
if(NOT FOLDLESS_SANITIZE)
  add_test(NAME LateLibraries.AreLoadedWhereTheyAreUsed
           COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/late_libraries_test.sh $<TARGET_FILE:foldless>
                   ${PROJECT_SOURCE_DIR}/assets)
  set(libraries "")
  foreach(library mesh files linear cone energy solve remesh multires construct scene method run)
    list(APPEND libraries $<TARGET_FILE:foldless_${library}>)
  endforeach()
  add_test(NAME Symbols.OfOthersAreNotDefined
           COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} -DPROGRAM=$<TARGET_FILE:foldless>
                   "-DLIBRARIES=${libraries}" -P ${CMAKE_CURRENT_SOURCE_DIR}/symbols_test.cmake)
  add_library(foreign_symbols STATIC symbols/foreign_symbols.cpp)
  add_test(NAME Symbols.OfOthersAreFound
           COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} -DLIBRARIES=$<TARGET_FILE:foreign_symbols>
                   -P ${CMAKE_CURRENT_SOURCE_DIR}/symbols_test.cmake)
  set_tests_properties(Symbols.OfOthersAreFound PROPERTIES PASS_REGULAR_EXPRESSION
    "defines GOMP_parallel.*defines SuiteSparse_time.*defines dgemm_.*defines dpotrf_")
endif()
