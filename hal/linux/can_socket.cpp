// SPDX-License-Identifier: MIT
#include "hal/linux/can_socket.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

#include "hal/linux/can_error.hpp"
#include "hal/linux/can_interface.hpp"

namespace fantail::hal::on_linux {
namespace {

// A quarter of a second of a full bus: longer than a desktop makes a program wait.
constexpr int receive_buffer = 4 << 20;

can_filter to_kernel(const CanFilter& filter) {
  // The flag is part of the mask: an 11-bit filter lets no 29-bit frame with the same low bits through.
  const std::uint32_t bits = filter.extended ? CAN_EFF_MASK : CAN_SFF_MASK;
  return {.can_id = (filter.id & bits) | (filter.extended ? CAN_EFF_FLAG : 0U),
          .can_mask = (filter.mask & bits) | CAN_EFF_FLAG};
}

can_frame to_kernel(const CanFrame& frame) {
  can_frame raw{};
  raw.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0U) | (frame.remote ? CAN_RTR_FLAG : 0U);
  raw.can_dlc = frame.length;
  if (!frame.remote) {
    std::copy_n(frame.data.begin(), frame.length, std::begin(raw.data));
  }
  return raw;
}

CanFrame from_kernel(const can_frame& raw) {
  CanFrame frame;
  frame.extended = (raw.can_id & CAN_EFF_FLAG) != 0;
  frame.remote = (raw.can_id & CAN_RTR_FLAG) != 0;
  frame.id = raw.can_id & (frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
  frame.length = std::min<std::uint8_t>(raw.can_dlc, CAN_MAX_DLEN);
  if (!frame.remote) {
    std::copy_n(std::begin(raw.data), frame.length, frame.data.begin());
  }
  return frame;
}

ErrorFrame error_from_kernel(const can_frame& raw) {
  ErrorFrame error;
  const auto has = [&raw](std::uint32_t what) { return (raw.can_id & what) != 0; };
  if (has(CAN_ERR_RESTARTED)) {
    error.state = CanState::error_active;
  }
  if (has(CAN_ERR_CRTL)) {
    const unsigned controller = raw.data[1];
    if ((controller & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) != 0) {
      error.state = CanState::error_passive;
    } else if ((controller & (CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING)) != 0) {
      error.state = CanState::error_warning;
    } else if ((controller & CAN_ERR_CRTL_ACTIVE) != 0) {
      error.state = CanState::error_active;
    }
    error.controller_overrun = (controller & CAN_ERR_CRTL_RX_OVERFLOW) != 0;
  }
  if (has(CAN_ERR_BUSOFF)) {
    error.state = CanState::bus_off;
  }
  return error;
}

/// What a failed call says about the interface; `otherwise` when it says nothing.
template <typename Result>
Result fate_of_interface(int error, Result otherwise) {
  switch (error) {
    case ENETDOWN:
    case ENETUNREACH: return Result::down;
    case ENODEV:
    case ENXIO: return Result::vanished;
    default: return otherwise;
  }
}

template <typename Value>
bool set(int descriptor, int level, int option, const Value& value) {
  return setsockopt(descriptor, level, option, &value, sizeof value) == 0;
}

Wake sleep_on(pollfd* descriptors, nfds_t count, std::chrono::microseconds longest) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(longest);
  const timespec pause{.tv_sec = seconds.count(), .tv_nsec = std::chrono::nanoseconds{longest - seconds}.count()};
  const int ready = ppoll(descriptors, count, &pause, nullptr);
  if (ready < 0) {
    return Wake::signal;
  }
  return ready > 0 ? Wake::arrived : Wake::time_out;
}

}  // namespace

bool fits_can(const CanFrame& frame) {
  return frame.length <= CAN_MAX_DLEN && frame.id <= (frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
}

Wake sleep_deaf(std::chrono::microseconds longest) { return sleep_on(nullptr, 0, longest); }

CanSocket::CanSocket(std::string interface, std::span<const CanFilter> filters)
    : interface_{std::move(interface)}, filters_{filters.begin(), filters.end()} {
  if (filters_.empty()) {
    filters_.push_back({});
  }
  descriptor_ = opened();
}

CanSocket::~CanSocket() { close(descriptor_); }

int CanSocket::opened() {
  const int made = socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW);
  if (made < 0) {
    throw CanError{socket_trouble(interface_, errno)};
  }
  try {
    const Interface found = usable_interface(interface_);
    std::vector<can_filter> kernel_filters(filters_.size());
    std::transform(filters_.begin(), filters_.end(), kernel_filters.begin(),
                   [](const CanFilter& filter) { return to_kernel(filter); });
    const can_err_mask_t all_errors = CAN_ERR_MASK;
    // Only root may ask for more than the system's limit; the others get that limit.
    if (!set(made, SOL_SOCKET, SO_RCVBUFFORCE, receive_buffer)) {
      set(made, SOL_SOCKET, SO_RCVBUF, receive_buffer);
    }
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = found.index;
    if (setsockopt(made, SOL_CAN_RAW, CAN_RAW_FILTER, kernel_filters.data(),
                   static_cast<socklen_t>(kernel_filters.size() * sizeof(can_filter))) != 0 ||
        !set(made, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, all_errors) || !set(made, SOL_SOCKET, SO_RXQ_OVFL, 1) ||
        bind(made, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
      throw CanError{socket_trouble(interface_, errno)};
    }
    index_ = found.index;
    lost_ = 0;
  } catch (...) {
    close(made);
    throw;
  }
  return made;
}

bool CanSocket::reopen() {
  try {
    const int made = opened();
    const bool moved = dup3(made, descriptor_, O_CLOEXEC) >= 0;
    close(made);
    return moved;
  } catch (const CanError&) {
    return false;
  }
}

WriteResult CanSocket::write(const CanFrame& frame) const {
  const can_frame raw = to_kernel(frame);
  for (;;) {
    if (::write(descriptor_, &raw, sizeof raw) >= 0) {
      return WriteResult::done;
    }
    switch (errno) {
      case EINTR: continue;
      case ENOBUFS:
      case EAGAIN: return WriteResult::full;
      default: return fate_of_interface(errno, WriteResult::refused);
    }
  }
}

Arrival CanSocket::read() {
  can_frame raw{};
  iovec part{.iov_base = &raw, .iov_len = sizeof raw};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(std::uint32_t))> control{};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  const ssize_t got = recvmsg(descriptor_, &message, 0);
  if (got < 0) {
    return {.kind = fate_of_interface(errno, ArrivalKind::nothing)};
  }
  Arrival arrival;
  for (cmsghdr* each = CMSG_FIRSTHDR(&message); each != nullptr; each = CMSG_NXTHDR(&message, each)) {
    if (each->cmsg_level == SOL_SOCKET && each->cmsg_type == SO_RXQ_OVFL) {
      std::uint32_t lost = 0;
      std::memcpy(&lost, CMSG_DATA(each), sizeof lost);
      arrival.lost = lost - std::exchange(lost_, lost);
    }
  }
  if (got != sizeof raw) {
    return arrival;
  }
  if ((raw.can_id & CAN_ERR_FLAG) != 0) {
    arrival.kind = ArrivalKind::error;
    arrival.error = error_from_kernel(raw);
  } else {
    arrival.kind = ArrivalKind::frame;
    arrival.frame = from_kernel(raw);
  }
  return arrival;
}

Wake CanSocket::sleep(std::chrono::microseconds longest) const {
  pollfd listening{.fd = descriptor_, .events = POLLIN, .revents = 0};
  return sleep_on(&listening, 1, longest);
}

}  // namespace fantail::hal::on_linux
