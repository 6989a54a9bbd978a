# The open recogniser that ships as an example: its lines and its nearest sentence, without the model.
add_test(NAME "system: the open recogniser answers with the nearest sentence, and takes no nonsense"
         COMMAND ${CMAKE_SOURCE_DIR}/tests/system/open_recogniser.sh ${CMAKE_SOURCE_DIR})
set_tests_properties("system: the open recogniser answers with the nearest sentence, and takes no nonsense"
                     PROPERTIES LABELS system TIMEOUT 60 SKIP_RETURN_CODE 77)
