// SPDX-License-Identifier: MIT
#include "input/rasp_file.hpp"

#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "test.hpp"
#include "text/error.hpp"

namespace fantail::input {
namespace {

const std::string header = "K1 54 400 0 0.5 1.2 maker\n";

class RaspFile : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  sim::ThrustCurve load(const std::string& content, const std::optional<std::string>& motor = {}) {
    std::ofstream{file_, std::ios::binary} << content;
    return load_rasp(file_, motor).curve;
  }

  // Expects bad data at a line, with all the words that a person needs.
  void expect_refused(const std::string& content, int line, std::initializer_list<const char*> words,
                      const std::optional<std::string>& motor = {}) {
    try {
      (void)load(content, motor);
      ADD_FAILURE() << "accepted: " << content;
    } catch (const text::Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(error.kind(), text::ErrorKind::bad_data);
      EXPECT_TRUE(message.starts_with(file_.string() + ":" + std::to_string(line) + ": ")) << message;
      for (const char* word : words) {
        EXPECT_NE(message.find(word), std::string::npos) << message << " lacks " << word;
      }
    }
  }

  std::filesystem::path file_ =
      std::filesystem::path{testing::TempDir()} / ("fantail_rasp_" + std::to_string(getpid()) + ".eng");
};

TEST_F(RaspFile, CanonicalMotorHasThePublishedImpulse) {
  const sim::ThrustCurve motor = load_rasp(std::filesystem::path{FANTAIL_TEST_MOTORS} / "i150_canonical.eng").curve;
  EXPECT_NEAR(motor.impulse_n_s(), 465.4, 0.05);
  EXPECT_DOUBLE_EQ(motor.propellant_kg(), 0.226);
  EXPECT_DOUBLE_EQ(motor.burnout_s(), 3.2);
  EXPECT_DOUBLE_EQ(motor.thrust_n(0.7), 173.0);
}

TEST_F(RaspFile, ReadsHeaderCommentsAndPairs) {
  const sim::ThrustCurve motor = load("; a comment\n;another\n\n" + header + "0 0\n 0.5\t10 ; peak\n1.0 0\n;\n");
  EXPECT_DOUBLE_EQ(motor.propellant_kg(), 0.5);
  EXPECT_DOUBLE_EQ(motor.impulse_n_s(), 5.0);
}

TEST_F(RaspFile, FirstPointAfterIgnitionMeansThatThrustRisesFromZero) {
  EXPECT_DOUBLE_EQ(load(header + "0.5 10\n1.0 0\n").thrust_n(0.25), 5.0);
}

TEST_F(RaspFile, MayStartAtFullThrust) { EXPECT_DOUBLE_EQ(load(header + "0 10\n1.0 0\n").thrust_n(0.0), 10.0); }

TEST_F(RaspFile, ReadsWindowsLineEndsAndAByteOrderMark) {
  EXPECT_DOUBLE_EQ(load("\xEF\xBB\xBF; x\r\nK1 54 400 0 0.5 1.2 maker\r\n0.5 10\r\n1.0 0\r\n").impulse_n_s(), 5.0);
}

const std::string several = header + "0.5 10\n1.0 0\n;\nK2 54 400 0 0.5 1.2 maker\n0.5 20\n1.0 0\n";

TEST_F(RaspFile, OfSeveralMotorsOneIsChosenByName) {
  EXPECT_DOUBLE_EQ(load(several, "K1").impulse_n_s(), 5.0);
  EXPECT_DOUBLE_EQ(load(several, "K2").impulse_n_s(), 10.0);
}

TEST_F(RaspFile, SeveralMotorsAreRefusedWithTheirNamesAndTheWayToChoose) {
  expect_refused(several, 5, {"second motor", "K1, K2", "#K1\""});
}

TEST_F(RaspFile, AMotorThatIsNotInTheFileIsRefusedWithThoseThatAre) {
  expect_refused(several, 1, {"\"K3\"", "did you mean K1?", "allowed: K1, K2"}, "K3");
  expect_refused(header + "0.5 10\n1.0 0\n", 1, {"\"M1\"", "allowed: K1"}, "M1");
}

TEST_F(RaspFile, TwoMotorsOfOneNameCannotBeToldApart) {
  expect_refused(header + "0.5 10\n1.0 0\n" + header + "0.5 20\n1.0 0\n", 4, {"second motor called \"K1\""}, "K1");
}

TEST_F(RaspFile, OnlyTheChosenMotorIsJudged) {
  const std::string broken = header + "0.5 10\n1.0 0\nK2 54 400 0 nonsense 1.2 maker\n0.5 99\n";
  EXPECT_DOUBLE_EQ(load(broken, "K1").impulse_n_s(), 5.0);
  expect_refused(broken, 4, {"propellant mass", "nonsense"}, "K2");
}

TEST_F(RaspFile, AMakerMayHaveTwoWords) {
  EXPECT_DOUBLE_EQ(load("K1 54 400 6-10-14 0.5 1.2 Two Words\n0.5 10\n1.0 0\n").impulse_n_s(), 5.0);
}

TEST_F(RaspFile, SaysThatAFileDoesNotExist) {
  for (const std::filesystem::path& missing :
       {std::filesystem::path{"/nonexistent/motor.eng"}, std::filesystem::path{testing::TempDir()}}) {
    try {
      (void)load_rasp(missing);
      ADD_FAILURE() << missing;
    } catch (const text::Error& error) {
      EXPECT_EQ(error.kind(), text::ErrorKind::no_such_input);
      EXPECT_NE(std::string{error.what()}.find(missing.string()), std::string::npos);
    }
  }
}

TEST_F(RaspFile, RefusesTimeThatGoesBackOrStands) {
  expect_refused(header + "0.5 10\n0.4 9\n1.0 0\n", 3, {"0.4", "0.5", "increasing"});
  expect_refused(header + "0.5 10\n0.5 9\n1.0 0\n", 3, {"0.5", "increasing"});
  expect_refused(header + "-0.5 10\n1.0 0\n", 2, {"-0.5", "ignition"});
}

TEST_F(RaspFile, RefusesNegativeThrust) {
  expect_refused("; one line more\n" + header + "0.5 10\n0.7 -3\n1.0 0\n", 4, {"-3", "not negative"});
}

TEST_F(RaspFile, RefusesWhatIsNotAFiniteNumber) {
  expect_refused(header + "0.5 nan\n1.0 0\n", 2, {"thrust", "nan", "finite"});
  expect_refused(header + "0.5 10\ninf 0\n", 3, {"time", "inf", "finite"});
  expect_refused(header + "0.5 1e999\n1.0 0\n", 2, {"1e999", "finite"});
  expect_refused(header + "0,5 10\n1.0 0\n", 2, {"0,5", "decimal point"});
  expect_refused(header + "0.5 10N\n1.0 0\n", 2, {"10N"});
}

TEST_F(RaspFile, RefusesGarbage) {
  expect_refused("hello\n", 1, {"1 words", "propellant_kg"});
  expect_refused(header + "0.5 10 7\n1.0 0\n", 2, {"3 words", "seconds newtons"});
  expect_refused(header + "0.5\n1.0 0\n", 2, {"1 words", "seconds newtons"});
  expect_refused(std::string{"\0\x01\x02\xff\n", 5}, 1, {"words"});
}

TEST_F(RaspFile, RefusesAFileWithoutData) {
  expect_refused("", 1, {"no motor"});
  expect_refused("; only\n; comments\n", 2, {"no motor"});
  expect_refused(header, 1, {"no thrust points"});
  expect_refused(header + "0.0 0\n", 1, {"two points"});
  expect_refused(header + "0.5 0\n", 1, {"impulse"});
}

TEST_F(RaspFile, RefusesPropellantThatIsNotThereOrOutweighsTheMotor) {
  expect_refused("K1 54 400 0 0 1.2 maker\n0.5 10\n1.0 0\n", 1, {"propellant", "above zero"});
  expect_refused("K1 54 400 0 -0.1 1.2 maker\n0.5 10\n1.0 0\n", 1, {"propellant", "-0.1", "above zero"});
  expect_refused("K1 54 400 0 1.3 1.2 maker\n0.5 10\n1.0 0\n", 1, {"1.3", "total mass", "1.2"});
  expect_refused("K1 54 400 0 nan 1.2 maker\n0.5 10\n1.0 0\n", 1, {"propellant", "nan"});
  expect_refused("K1 wide 400 0 0.5 1.2 maker\n0.5 10\n1.0 0\n", 1, {"diameter", "wide"});
}

TEST_F(RaspFile, AThrustThatIsLeftAtTheEndIsCutOffWithAWarning) {
  std::ofstream{file_, std::ios::binary} << header + "0.5 10\n1.0 4\n; the end\n";
  const RaspMotor motor = load_rasp(file_);
  // Two pieces of straight line, and a millisecond from 4 N to nothing.
  EXPECT_NEAR(motor.curve.impulse_n_s(), 2.5 + 3.5 + 0.002, 1e-12);
  EXPECT_DOUBLE_EQ(motor.curve.burnout_s(), 1.001);
  EXPECT_EQ(motor.warning, file_.string() +
                               ":3: the last thrust is 4 N at 1 s, not zero; assumed: the motor is out one "
                               "millisecond later.");
}

TEST_F(RaspFile, ACurveThatEndsAtZeroHasNoWarning) {
  std::ofstream{file_, std::ios::binary} << header + "0.5 10\n1.0 0\n";
  EXPECT_EQ(load_rasp(file_).warning, std::nullopt);
}

TEST_F(RaspFile, AThrustThatIsLeftAtATimeTooLargeForAMillisecondIsRefused) {
  expect_refused(header + "0.5 10\n1e18 4\n", 3, {"4 N", "zero"});
}

}  // namespace
}  // namespace fantail::input
