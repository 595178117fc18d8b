# SPDX-License-Identifier: MIT
# What CPack runs before it packs: Debian's man pages are compressed, and those of ./dev install are not.
file(GLOB_RECURSE pages ${CPACK_TEMPORARY_DIRECTORY}/*/usr/share/man/*.[1-8])
if(pages)
  execute_process(COMMAND gzip -9n -f ${pages} COMMAND_ERROR_IS_FATAL ANY)
endif()
