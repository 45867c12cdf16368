# cmake -D SOURCE=<tree> -D GIVEN=<description or nothing> -D OUTPUT=<file.cc> -P git_description.cmake, with every build:
# says in C++ what git says of the tree, or what is given where there is no git. The file is touched only where that
# changes.
set(description "unknown")
execute_process(COMMAND git -C ${SOURCE} describe --tags --always --dirty
                OUTPUT_VARIABLE said OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failure)
if(GIVEN)
  set(description "${GIVEN}")
elseif(failure STREQUAL "0" AND said)
  set(description "${said}")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [=[
#include "server/build_information.h"

namespace dualarm {

const char* const kGitDescription = "@description@";

}  // namespace dualarm
]=])
