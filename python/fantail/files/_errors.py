# SPDX-License-Identifier: MIT
class BadFile(ValueError):
    """A file that cannot be what its name says, or holds no table; str() says why, without its name."""
