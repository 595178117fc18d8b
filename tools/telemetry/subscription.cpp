// SPDX-License-Identifier: MIT
#include "telemetry/subscription.hpp"

#include <cerrno>
#include <cstring>

#include <lcm/lcm.h>
#include <poll.h>
#include <unistd.h>

namespace fantail::telemetry {
namespace {

// LCM keeps 30 otherwise, and throws away what comes while the listener is busy for a moment.
constexpr int most_waiting = 10'000;

}  // namespace

struct Subscription::Lcm {
  ~Lcm() {
    if (handle != nullptr) {
      lcm_destroy(handle);
    }
  }
  static void hand_over(const lcm_recv_buf_t* buffer, const char* channel, void* user) {
    const auto* self = static_cast<const Lcm*>(user);
    (*self->take)(channel, {static_cast<const std::byte*>(buffer->data), buffer->data_size});
  }
  [[nodiscard]] bool has_something() const {
    pollfd descriptor{.fd = lcm_get_fileno(handle), .events = POLLIN, .revents = 0};
    return ::poll(&descriptor, 1, 0) > 0;
  }

  lcm_t* handle = nullptr;
  bool is_file = false;
  const Take* take = nullptr;  ///< in a call of listen()
};

Subscription::Subscription(const Url& url) : lcm_{std::make_unique<Lcm>()} {
  lcm_->is_file = url.is_file();
  if (!url.is_file()) {
    require_route(url);
  } else if (::access(url.path().c_str(), R_OK) != 0) {
    throw TelemetryError{url.path() + ": " + std::strerror(errno)};
  }
  lcm_->handle = lcm_create(url.text().c_str());
  lcm_subscription_t* const heard =
      lcm_->handle == nullptr ? nullptr : lcm_subscribe(lcm_->handle, "FANTAIL_.*", Lcm::hand_over, lcm_.get());
  if (heard == nullptr) {
    throw TelemetryError{url.text() + (url.is_file() ? ": not an LCM log, or an empty one"
                                                     : ": LCM cannot listen there; see its own message above")};
  }
  lcm_subscription_set_queue_capacity(heard, most_waiting);
}

Subscription::~Subscription() = default;

void Subscription::wait(std::chrono::milliseconds at_most) const {
  pollfd descriptor{.fd = lcm_get_fileno(lcm_->handle), .events = POLLIN, .revents = 0};
  (void)::poll(&descriptor, 1, static_cast<int>(at_most.count()));
}

bool Subscription::listen(const Take& take) {
  lcm_->take = &take;
  // A log played as fast as it goes always has something; the listener must get round to showing it.
  for (int i = 0; i < most_waiting && lcm_->has_something(); ++i) {
    if (lcm_handle(lcm_->handle) < 0) {
      return false;
    }
  }
  return true;
}

}  // namespace fantail::telemetry
