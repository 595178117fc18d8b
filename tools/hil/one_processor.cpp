// SPDX-License-Identifier: MIT
#include "hil/one_processor.hpp"

#include <cstddef>

#include <unistd.h>

namespace fantail::hil {

OneProcessor::OneProcessor() : thread_{::gettid()} {
  const int here = ::sched_getcpu();
  if (here < 0 || ::sched_getaffinity(thread_, sizeof before_, &before_) != 0) {
    return;  // it is only about speed
  }
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<std::size_t>(here), &one);
  bound_ = ::sched_setaffinity(thread_, sizeof one, &one) == 0;
}

OneProcessor::~OneProcessor() {
  if (bound_) {
    (void)::sched_setaffinity(thread_, sizeof before_, &before_);
  }
}

}  // namespace fantail::hil
