// SPDX-License-Identifier: MIT
// What tests of a property over drawn cases read: rapidcheck wants googletest before it.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "test.hpp"
