// SPDX-License-Identifier: MIT
// What a person is told who has no bus; on any kernel, with CAN or without.
#include <cerrno>

#include <linux/can.h>
#include <sys/socket.h>
#include <unistd.h>

#include "hal/linux/can_bus.hpp"
#include "hal/linux/can_interface.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

using hal::on_linux::CanBus;
using hal::on_linux::CanError;
using hal::on_linux::find_interface;
using hal::on_linux::socket_trouble;
using hal::on_linux::usable_interface;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

template <typename Action>
std::string trouble(Action action) {
  try {
    action();
  } catch (const CanError& error) {
    return error.what();
  }
  return "none";
}

TEST(LinuxCanTrouble, ABusThatIsNotThereThrowsOneLineThatSaysWhatToDo) {
  const std::string said = trouble([] { const CanBus bus{"fantail_none"}; });
  EXPECT_TRUE(said.starts_with("fantail_none: ")) << said;
  EXPECT_TRUE(contains(said, "with_vcan COMMAND (in tools/ of the sources")) << said;
  EXPECT_FALSE(contains(said, "\n")) << said;
}

TEST(LinuxCanTrouble, AKernelWithoutCanIsNamedAsTheCause) {
  for (const int error : {EAFNOSUPPORT, EPROTONOSUPPORT}) {
    const std::string said = socket_trouble("can0", error);
    EXPECT_TRUE(said.starts_with("can0: this kernel has no CAN; try sudo modprobe can_raw; ")) << said;
    EXPECT_TRUE(contains(said, "with_vcan COMMAND (in tools/ of the sources")) << said;
  }
}

TEST(LinuxCanTrouble, TheConstructorNamesThatCauseOnSuchAKernel) {
  const int can = socket(PF_CAN, SOCK_RAW, CAN_RAW);
  const int error = errno;
  const std::string said = trouble([] { const CanBus bus{"can0"}; });
  if (can < 0) {
    EXPECT_EQ(said, socket_trouble("can0", error));
  } else {
    close(can);
    EXPECT_FALSE(contains(said, "this kernel has no CAN")) << said;
  }
}

TEST(LinuxCanTrouble, AForbiddenSocketIsNotTakenForAMissingOne) {
  EXPECT_TRUE(socket_trouble("can0", EPERM).starts_with("can0: no permission"));
  EXPECT_TRUE(contains(socket_trouble("can0", ENFILE), "can0: no CAN socket: "));
}

TEST(LinuxCanTrouble, ARealAdapterIsToldItsBitRateAndAVirtualOneIsNot) {
  const std::string adapter = trouble([] { (void)usable_interface("can17"); });
  EXPECT_TRUE(contains(adapter, "with a 1 Mbit/s adapter: sudo ip link set can17 up type can bitrate 1000000"))
      << adapter;
  const std::string other = trouble([] { (void)usable_interface("vcan17"); });
  EXPECT_TRUE(contains(other, "sudo ip link set can0 up type can bitrate 1000000")) << other;
  EXPECT_FALSE(contains(other, "vcan17 up type can")) << other;
}

TEST(LinuxCanTrouble, TheLoopbackInterfaceIsFoundAndIsNotCan) {
  const auto found = find_interface("lo");
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->can);
  EXPECT_GT(found->index, 0);
  EXPECT_TRUE(trouble([] { (void)usable_interface("lo"); }).starts_with("lo: not a CAN interface"));
}

TEST(LinuxCanTrouble, ANameThatIsTooLongIsNotCutShort) {
  EXPECT_FALSE(find_interface("a_name_of_sixteen"));
  EXPECT_FALSE(find_interface(""));
}

}  // namespace
}  // namespace fantail::test
