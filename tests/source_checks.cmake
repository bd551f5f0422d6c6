# SPDX-License-Identifier: GPL-3.0-or-later
# Checks that look at text alone, whatever is built.

add_test(NAME Layering.HoldsInTheSources
         COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                 -P ${CMAKE_CURRENT_SOURCE_DIR}/layering_test.cmake)
add_test(NAME Layering.ComplainsAboutEachBrokenRule
         COMMAND ${CMAKE_COMMAND} -DTEST=${CMAKE_CURRENT_SOURCE_DIR}/layering_test.cmake
                 -DTREE=${CMAKE_CURRENT_BINARY_DIR}/layering_tree
                 -P ${CMAKE_CURRENT_SOURCE_DIR}/layering_self_test.cmake)

add_test(NAME PaperTable.NamesWhatIsInTheSources
         COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                 -P ${CMAKE_CURRENT_SOURCE_DIR}/paper_table_test.cmake)
add_test(NAME PaperTable.ComplainsAboutEachBrokenRow
         COMMAND ${CMAKE_COMMAND} -DTEST=${CMAKE_CURRENT_SOURCE_DIR}/paper_table_test.cmake
                 -DTREE=${CMAKE_CURRENT_BINARY_DIR}/paper_table_tree
                 -P ${CMAKE_CURRENT_SOURCE_DIR}/paper_table_self_test.cmake)

add_test(NAME Pages.HaveNoLinkThatLeadsNowhere
         COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/docs/links.py ${PROJECT_SOURCE_DIR})
add_test(NAME Pages.EachBrokenLinkIsTold
         COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/docs/links.py --self-test)
add_test(NAME Pages.ReadmeIsShortAndTablesSayWhereTheyAreFrom
         COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/docs/pages.py ${PROJECT_SOURCE_DIR})
add_test(NAME Pages.EachSpoiltPageIsTold
         COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/docs/pages.py --self-test)

add_test(NAME GesturesTable.NamesTestsThatAreThere
         COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                 -P ${CMAKE_CURRENT_SOURCE_DIR}/gestures_table_test.cmake)

add_test(NAME Rooms.AreNeitherCrowdedNorCircular
         COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                 -P ${CMAKE_CURRENT_SOURCE_DIR}/rooms_test.cmake)
add_test(NAME Rooms.ComplainsAboutEachBrokenRule
         COMMAND ${CMAKE_COMMAND} -DTEST=${CMAKE_CURRENT_SOURCE_DIR}/rooms_test.cmake
                 -DTREE=${CMAKE_CURRENT_BINARY_DIR}/rooms_tree
                 -P ${CMAKE_CURRENT_SOURCE_DIR}/rooms_self_test.cmake)

file(GLOB EDITOR_HEADERS ${PROJECT_SOURCE_DIR}/app/editor/*.h)
add_test(NAME Facades.NoClassOfTheEditorHasMoreThanThirtyPublicMembers
         COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/public_members.py ${EDITOR_HEADERS})
add_test(NAME Facades.OneMemberTooManyIsTold
         COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/public_members.py --self-test)

find_program(CLANG_FORMAT NAMES clang-format-14 clang-format)
if(CLANG_FORMAT)
  add_test(NAME Format.HoldsInTheSources
           COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                   -DCLANG_FORMAT=${CLANG_FORMAT} -P ${CMAKE_CURRENT_SOURCE_DIR}/format_test.cmake)
  set_tests_properties(Format.HoldsInTheSources PROPERTIES SKIP_REGULAR_EXPRESSION "SKIPPED:")
endif()
