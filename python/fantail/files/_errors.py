# SPDX-License-Identifier: MIT
class BadFile(ValueError):
    """A file that is not of the kind in its name, or has no table; str() gives the reason, without its name."""
