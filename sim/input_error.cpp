// SPDX-License-Identifier: MIT
#include "sim/input_error.hpp"
