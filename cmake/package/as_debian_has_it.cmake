# SPDX-License-Identifier: MIT
# What CPack runs before it packs. In Debian man pages are compressed, and zsh looks elsewhere for what packages complete.
file(GLOB roots ${CPACK_TEMPORARY_DIRECTORY} ${CPACK_TEMPORARY_DIRECTORY}/*)
foreach(root IN LISTS roots)
  file(GLOB pages ${root}/usr/share/man/man*/*.[1-8])
  if(pages)
    execute_process(COMMAND gzip -9n -f ${pages} COMMAND_ERROR_IS_FATAL ANY)
  endif()
  if(EXISTS ${root}/usr/share/zsh/site-functions)
    file(RENAME ${root}/usr/share/zsh/site-functions ${root}/usr/share/zsh/vendor-completions)
  endif()
endforeach()
