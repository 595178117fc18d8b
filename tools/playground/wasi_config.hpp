// SPDX-License-Identifier: MIT
// Included ahead of everything (-include). libc++ for WASI leaves <fstream> and <filesystem> empty, where toml++ and
// headers of ours name std::ifstream and std::filesystem::path. Nothing here opens a file, so that the declarations are
// enough.
#include <__config>
#undef _LIBCPP_HAS_NO_FILESYSTEM
