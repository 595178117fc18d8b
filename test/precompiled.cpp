// SPDX-License-Identifier: MIT
// Of the target test_precompiled, which is nothing but its header.
