# The open recogniser that ships as an example: its lines and its nearest sentence, without the model.
fulcrum_system_test("the open recogniser answers with the nearest sentence, and takes no nonsense" open_recogniser.sh
                    WITH ${CMAKE_SOURCE_DIR} MAY_SKIP TIMEOUT 60)
