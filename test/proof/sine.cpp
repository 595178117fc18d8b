// SPDX-License-Identifier: MIT
// The sine of any number of turns, as the chirp uses it, is within 1.0000002 of zero for up to a million turns to
// either side; beyond them, and for what is not a number, it is not a number, so that whoever commands it refuses it.
#include "core/finite.hpp"
#include "core/trig.cpp"
#include "proof.hpp"

using namespace fantail;
using namespace fantail::core;
using namespace fantail::proof;

int main() {
  const float turns = nondet_float();
  const float sine = core::sin_turns(turns);
  const bool in_range = turns >= -1e6F && turns <= 1e6F;

  CLAIM(!in_range || (sine >= -1.0000002F && sine <= 1.0000002F));
  CLAIM(in_range || !is_finite(sine));

  REACHABLE(1, in_range && sine > 0.9F);
  REACHABLE(2, !in_range);
  return 0;
}
