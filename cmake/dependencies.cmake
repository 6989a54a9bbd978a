# Everything comes from Debian packages; packages.txt names each with its reason.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(tl-expected REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(glfw3 REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS EGL)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(freetype REQUIRED IMPORTED_TARGET freetype2)
pkg_check_modules(harfbuzz REQUIRED IMPORTED_TARGET harfbuzz)
pkg_check_modules(fribidi REQUIRED IMPORTED_TARGET fribidi)
pkg_check_modules(fontconfig REQUIRED IMPORTED_TARGET fontconfig)
# Opened while running, where a lesson calls for it (dialogue/checking/link_grammar).
pkg_check_modules(link_grammar REQUIRED link-grammar)
pkg_check_modules(sqlite REQUIRED IMPORTED_TARGET sqlite3)
pkg_check_modules(utf8proc REQUIRED IMPORTED_TARGET libutf8proc)
pkg_check_modules(sodium REQUIRED IMPORTED_TARGET libsodium)
pkg_check_modules(png REQUIRED IMPORTED_TARGET libpng)
pkg_check_modules(jpeg REQUIRED IMPORTED_TARGET libjpeg)
pkg_check_modules(lua REQUIRED IMPORTED_TARGET lua5.4-c++)

# fulcrum_part(OPTION text LEAVES_OUT pattern … INSTEAD folder): a part that a build can go without. Where the option is off, no source
# is compiled whose path holds one of the patterns, but those of INSTEAD, the same functions without the vendor: they say in a sentence
# what the build does not have. Tests lie as their sources do. FULCRUM_LEFT_OUT has what is not compiled; FULCRUM_INSTEADS what stands
# for something.
set(FULCRUM_LEFT_OUT)
set(FULCRUM_INSTEADS)
macro(fulcrum_part option text)
  cmake_parse_arguments(part "" "INSTEAD" "LEAVES_OUT" ${ARGN})
  option(${option} "${text}" ON)
  if(${option})
    list(APPEND FULCRUM_LEFT_OUT ${part_INSTEAD}/)
    list(APPEND FULCRUM_INSTEADS ${part_INSTEAD})
  else()
    list(APPEND FULCRUM_LEFT_OUT ${part_LEAVES_OUT})
  endif()
endmacro()

fulcrum_part(FULCRUM_SOUND "sounds, voices and microphones, by OpenAL" LEAVES_OUT runtime/audio/openal/ INSTEAD runtime/audio/no_openal)
if(FULCRUM_SOUND)
  pkg_check_modules(openal REQUIRED IMPORTED_TARGET openal)
  set(FULCRUM_SOUND_VENDORS PkgConfig::openal)
endif()

fulcrum_part(FULCRUM_HID "SpaceMice and joysticks, by hidapi" LEAVES_OUT haptics/device/hid/hidapi/
             INSTEAD haptics/device/hid/no_hidapi)
if(FULCRUM_HID)
  pkg_check_modules(hidapi REQUIRED IMPORTED_TARGET hidapi-hidraw)
endif()

fulcrum_part(FULCRUM_SPEECH "answers heard by PocketSphinx, texts said by flite and espeak-ng"
             LEAVES_OUT dialogue/speech/sphinx/[^p] runtime/app/speech/ runtime/audio/openal/spoken_voice runtime/hearing/sphinx
                        runtime/hearing/ear_test runtime/hearing/speech_in_sound_test tests/lessons/sphinx/ bench/curves/hearing[.]cpp
             INSTEAD runtime/app/no_speech)
if(FULCRUM_SPEECH)
  # Its pkg-config file names a folder that the package does not have.
  pkg_check_modules(pocketsphinx REQUIRED pocketsphinx)
  add_library(pocketsphinx::pocketsphinx INTERFACE IMPORTED)
  foreach(folder IN LISTS pocketsphinx_INCLUDE_DIRS)
    if(IS_DIRECTORY ${folder})
      target_include_directories(pocketsphinx::pocketsphinx SYSTEM INTERFACE ${folder})
    endif()
  endforeach()
  target_link_libraries(pocketsphinx::pocketsphinx INTERFACE pocketsphinx sphinxbase)
endif()
