// SPDX-License-Identifier: MIT
// Of targets that are nothing but their precompiled header.
