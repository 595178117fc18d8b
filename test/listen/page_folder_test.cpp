// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "listen/answer.hpp"
#include "system/folder.hpp"

namespace fantail::listen {
namespace {

TEST(PageFolder, IsNamedAfterTheLogWhereNobodyElsesPageIs) {
  const test::Folder folder;
  const std::string a = folder.write("a/log.csv", "x");
  const std::string b = folder.write("b/log.ulg", "x");
  const auto place = [&](const std::string& log) { return page_folder(folder.path() / "out", log); };
  EXPECT_EQ(place(a).folder, folder.path() / "out/log");
  folder.write("out/log/listen.json", "{\"log\": \"" + a + "\"}");
  EXPECT_EQ(place(a).folder, folder.path() / "out/log");
  EXPECT_EQ(place(a).remark, "");
  EXPECT_EQ(place(b).folder, folder.path() / "out/log_2");
  EXPECT_NE(place(b).remark.find(a), std::string::npos) << place(b).remark;
  folder.write("out/log_2/listen.json", "{\"log\": \"" + b + "\"}");
  EXPECT_EQ(place(b).folder, folder.path() / "out/log_2");
  EXPECT_EQ(place((folder.path() / "a/../a/log.csv").string()).folder, folder.path() / "out/log");
}

TEST(PageFolder, LeavesAPageThatDoesNotSayWhoseItIs) {
  const test::Folder folder;
  const std::string log = folder.write("log.csv", "x");
  for (const std::string json : {"", "{", "[1]", "{\"log\": 1}"}) {
    folder.write("out/log/listen.json", json);
    const PageFolder place = page_folder(folder.path() / "out", log);
    EXPECT_EQ(place.folder, folder.path() / "out/log_2") << json;
    EXPECT_TRUE(place.remark.starts_with((folder.path() / "out/log").string())) << place.remark;
  }
}

}  // namespace
}  // namespace fantail::listen
