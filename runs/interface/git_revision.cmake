# Run at every build: writes OUTPUT from TEMPLATE, and only when the revision of SOURCE has changed.
execute_process(
  COMMAND git --no-optional-locks -C ${SOURCE} describe --always --dirty --tags
  OUTPUT_VARIABLE REVISION
  RESULT_VARIABLE failed
  ERROR_QUIET
  OUTPUT_STRIP_TRAILING_WHITESPACE)
if(failed)
  set(REVISION unknown)
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
