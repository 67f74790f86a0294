# Fails when a text of the program is not translated, or a translation has lost its text:
# cmake -D ROOT=<source> -D LUPDATE=<lupdate> -D SCRATCH=<folder> -P translations.cmake
file(GLOB translations ${ROOT}/translations/*.ts)
foreach(translation ${translations})
  get_filename_component(name ${translation} NAME)
  file(COPY ${translation} DESTINATION ${SCRATCH})
  execute_process(
    COMMAND ${LUPDATE} ui app -locations none -no-ui-lines -no-obsolete -disable-heuristic sametext
            -disable-heuristic similartext -ts ${SCRATCH}/${name}
    WORKING_DIRECTORY ${ROOT} RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(failed)
    message(FATAL_ERROR "${LUPDATE} failed")
  endif()
  file(READ ${SCRATCH}/${name} wanted)
  string(REGEX MATCHALL "<source>[^<]*</source>[^<]*<translation type=\"unfinished\"" unfinished "${wanted}")
  foreach(text ${unfinished})
    string(REGEX REPLACE "^<source>([^<]*)<.*" "\\1" text "${text}")
    message(SEND_ERROR "translations/${name}: not translated: ${text}")
  endforeach()
  file(READ ${translation} kept)
  if(NOT unfinished AND NOT kept STREQUAL wanted)
    message(SEND_ERROR "translations/${name} holds texts that the program has no more; bring it up to date with\n"
                       "lupdate ui app -locations none -no-ui-lines -no-obsolete -ts translations/${name}")
  endif()
endforeach()
