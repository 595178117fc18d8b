// SPDX-License-Identifier: MIT
#pragma once

#include "input/document.hpp"
#include "input/shipped.hpp"

namespace fantail::input {

/// Refuses a file that has no key of the wanted kind but some of another kind of file, and says which kind it is. Only
/// scenarios, vehicles and plans are told apart. Throws text::Error.
void refuse_other_kind(const Document& document, Shipped wanted);

}  // namespace fantail::input
