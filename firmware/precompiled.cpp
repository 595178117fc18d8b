// SPDX-License-Identifier: MIT
// Of the target flight_precompiled, which is nothing but its header.
