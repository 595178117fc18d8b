// SPDX-License-Identifier: MIT
#include "hal/linux/can_interface.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <vector>

#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include "hal/linux/can_error.hpp"

namespace fantail::hal::on_linux {
namespace {

constexpr const char* with_vcan =
    "with_vcan COMMAND (in tools/ of the sources, in libexec/fantail/ of an installation)";

std::string without_hardware() {
  return std::string{"without hardware: "} + with_vcan +
         ", or sudo ip link add vcan0 type vcan && sudo ip link set vcan0 up";
}

bool is_virtual(const std::string& name) { return name.starts_with("vcan") || name.starts_with("vxcan"); }

std::string set_up(const std::string& name) {
  return "sudo ip link set " + name + (is_virtual(name) ? " up" : " up type can bitrate 1000000");
}

/// "; CAN interfaces here: can0, can1", or nothing when there is none.
std::string others() {
  std::vector<std::string> names;
  struct if_nameindex* const all = if_nameindex();
  for (const struct if_nameindex* each = all; each != nullptr && each->if_name != nullptr; ++each) {
    const auto found = find_interface(each->if_name);
    if (found && found->can) {
      names.emplace_back(each->if_name);
    }
  }
  if (all != nullptr) {
    if_freenameindex(all);
  }
  std::sort(names.begin(), names.end());
  std::string list;
  for (const std::string& name : names) {
    list += (list.empty() ? "; CAN interfaces here: " : ", ") + name;
  }
  return list;
}

}  // namespace

std::optional<Interface> find_interface(const std::string& name) {
  ifreq request{};
  if (name.empty() || name.size() >= sizeof request.ifr_name) {
    return {};
  }
  // Any socket may ask; this kind exists in every kernel.
  const int asking = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (asking < 0) {
    return {};
  }
  std::memcpy(request.ifr_name, name.c_str(), name.size() + 1);
  std::optional<Interface> found;
  if (ioctl(asking, SIOCGIFINDEX, &request) == 0) {
    found = Interface{.index = request.ifr_ifindex};
    found->up = ioctl(asking, SIOCGIFFLAGS, &request) == 0 && (request.ifr_flags & IFF_UP) != 0;
    found->can = ioctl(asking, SIOCGIFHWADDR, &request) == 0 && request.ifr_hwaddr.sa_family == ARPHRD_CAN;
  }
  close(asking);
  return found;
}

Interface usable_interface(const std::string& name) {
  if (name.empty() || name.size() >= IFNAMSIZ) {
    throw CanError{"\"" + name + "\": the name of an interface has 1 to " + std::to_string(IFNAMSIZ - 1) +
                   " letters, such as can0" + others()};
  }
  const auto found = find_interface(name);
  if (!found) {
    throw CanError{name + ": no such interface" + others() + "; with a 1 Mbit/s adapter: " +
                   set_up(is_virtual(name) ? "can0" : name) + "; " + without_hardware()};
  }
  if (!found->can) {
    throw CanError{name + ": not a CAN interface" + others() + "; with a 1 Mbit/s adapter: " + set_up("can0") + "; " +
                   without_hardware()};
  }
  if (!found->up) {
    throw CanError{name + ": the interface is down; " + set_up(name)};
  }
  return *found;
}

std::string socket_trouble(const std::string& name, int error) {
  if (error == EAFNOSUPPORT || error == EPROTONOSUPPORT) {
    return name + ": this kernel has no CAN; try sudo modprobe can_raw; " + without_hardware();
  }
  if (error == EPERM || error == EACCES) {
    return name + ": no permission to open a CAN socket (a container or a sandbox forbids it); try it outside, or " +
           with_vcan;
  }
  return name + ": no CAN socket: " + std::generic_category().message(error);
}

}  // namespace fantail::hal::on_linux
