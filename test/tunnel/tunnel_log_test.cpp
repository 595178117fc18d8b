// SPDX-License-Identifier: MIT
#include "tunnel/tunnel_log.hpp"

#include <gtest/gtest.h>

#include "logs/refused.hpp"
#include "system/folder.hpp"

namespace fantail::tunnel {
namespace {

using test::expect_refused;
using test::Folder;
using text::ErrorKind;

TEST(TunnelLog, IsReadFromAFolderOrAFileInAnyOrderOfColumns) {
  const Folder folder;
  folder.write("tunnel.csv", "wind_speed_m_s,note,time_s,fan_rpm\n22.1,x,0,1250\n22.0,y,2,1250\n");
  for (const std::string& path : {folder.path().string(), folder / "tunnel.csv"}) {
    const TunnelLog log = read_tunnel_log(path, {});
    EXPECT_EQ(log.name, path);
    EXPECT_EQ(log.time_s, (std::vector<double>{0.0, 2.0}));
    EXPECT_EQ(log.fan_rpm, (std::vector<double>{1250.0, 1250.0}));
    EXPECT_EQ(log.wind_speed_m_s, (std::vector<double>{22.1, 22.0}));
  }
}

TEST(TunnelLog, ColumnsMayHaveOtherNames) {
  const Folder folder;
  const std::string file = folder.write("k.csv", "t,RPM,WS\n0,570,10\n2,570,10.1\n");
  const auto named = [](const char* text) { return files::parse_columns(text, "--columns", tunnel_quantities); };
  const TunnelLog log = read_tunnel_log(file, named("time_s=t,fan_rpm=RPM,wind_speed=WS:km/h"));
  EXPECT_DOUBLE_EQ(log.wind_speed_m_s[0], 10.0 / 3.6);
  expect_refused(ErrorKind::bad_data, {"k.csv", "no column time_s", "RPM"}, [&] { (void)read_tunnel_log(file, {}); });
  expect_refused(ErrorKind::bad_configuration, {"rpm=RPM", "unknown quantity", "fan"}, [&] { (void)named("rpm=RPM"); });
}

TEST(TunnelLog, WhatCannotBeALogIsRefusedWithItsLine) {
  const Folder folder;
  const std::string head = "time_s,fan_rpm,wind_speed_m_s\n";
  const auto refused = [&](const std::string& rows, std::initializer_list<const char*> words) {
    const std::string file = folder.write("bad.csv", head + rows);
    expect_refused(ErrorKind::bad_data, words, [&] { (void)read_tunnel_log(file, {}); });
  };
  refused("0,570,10\n2,570,10\n1,570,10\n", {"bad.csv:4", "time_s is 1 after 2 in line 3", "increase"});
  refused("0,570,10\n2,570,10\n2,570,11\n", {"bad.csv:4", "time_s is 2 as in line 3", "wind_speed_m_s differs"});
  refused("0,570,10\n2,-1,10\n", {"bad.csv:3", "fan_rpm = \"-1\""});
  refused("0,570,10\n2,570,\n4,570,10\n", {"1 of 3 rows", "more than 1 %"});
  refused("0,570,10\n", {"fewer than two rows"});
  expect_refused(ErrorKind::no_such_input, {"none.csv"}, [&] { (void)read_tunnel_log(folder / "none.csv", {}); });
  std::filesystem::create_directory(folder / "empty");
  expect_refused(ErrorKind::no_such_input, {"empty", "no tunnel.csv"},
                 [&] { (void)read_tunnel_log(folder / "empty", {}); });
}

TEST(TunnelLogBeside, LiesInTheFolderOrNextToTheFile) {
  const Folder folder;
  EXPECT_FALSE(tunnel_log_beside(folder.path()).has_value());
  folder.write("tunnel.csv", "");
  folder.write("flight.csv", "");
  EXPECT_EQ(tunnel_log_beside(folder.path()), folder.path() / "tunnel.csv");
  EXPECT_EQ(tunnel_log_beside(folder / "flight.csv"), folder.path() / "tunnel.csv");
}

}  // namespace
}  // namespace fantail::tunnel
