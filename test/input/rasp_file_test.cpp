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
const std::string likely_header = "K1 54 400 0 0.005 1.2 maker\n";  // 1000 N s a kilogram

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

TEST_F(RaspFile, RefusesTimeThatGoesBack) {
  expect_refused(header + "0.5 10\n0.4 9\n1.0 0\n", 3, {"0.4", "0.5", "increasing"});
  expect_refused(header + "-0.5 10\n1.0 0\n", 2, {"-0.5", "ignition"});
}

TEST_F(RaspFile, RefusesNegativeThrust) {
  expect_refused("; one line more\n" + header + "0.5 10\n0.7 -3\n1.0 0\n", 4, {"-3", "not negative"});
}

TEST_F(RaspFile, RefusesWhatIsNotAFiniteNumber) {
  expect_refused(header + "0.5 nan\n1.0 0\n", 2, {"thrust", "nan", "finite"});
  expect_refused(header + "0.5 10\ninf 0\n", 3, {"time", "inf", "finite"});
  expect_refused(header + "0.5 1e999\n1.0 0\n", 2, {"1e999", "finite"});
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
  std::ofstream{file_, std::ios::binary} << likely_header + "0.5 10\n1.0 4\n; the end\n";
  const RaspMotor motor = load_rasp(file_);
  // Two pieces of straight line, and a millisecond from 4 N to nothing.
  EXPECT_NEAR(motor.curve.impulse_n_s(), 2.5 + 3.5 + 0.002, 1e-12);
  EXPECT_DOUBLE_EQ(motor.curve.burnout_s(), 1.001);
  EXPECT_EQ(motor.warning, file_.string() +
                               ":3: the last thrust is 4 N at 1 s, not zero; assumed: the motor is out one "
                               "millisecond later.");
}

TEST_F(RaspFile, ACurveThatEndsAtZeroHasNoWarning) {
  std::ofstream{file_, std::ios::binary} << likely_header + "0.5 10\n1.0 0\n";
  EXPECT_EQ(load_rasp(file_).warning, std::nullopt);
}

TEST_F(RaspFile, AStepAndAPointThatIsThereTwiceAreRead) {
  EXPECT_NEAR(load(header + "0 10\n0.5 10\n0.5 10\n1.0 10\n1.0 0\n").impulse_n_s(), 10.0, 1e-3);
}

TEST_F(RaspFile, IsReadAsOtherEditorsAndPeopleWriteIt) {
  const std::string plain = "K1 54 400 6-10 0.5 1.2 maker\n0.5 10\n1.0 0\n";
  std::string utf16 = "\xFF\xFE";
  std::string mac;
  for (const char c : plain) {
    utf16 += c;
    utf16 += '\0';
    mac += c == '\n' ? '\r' : c;
  }
  for (const std::string& written :
       {utf16, mac, "\xEF\xBB\xBF" + plain, std::string{"K1 54 400 6-10 0,5 1,2 maker\r\n0,5 10\r\n1,0 0\r\n"},
        std::string{"K1 54 400 6-10 0.5 1.2\n0.5 10\n1.0 0\n"}, "# from the stand\n" + plain}) {
    EXPECT_DOUBLE_EQ(load(written).impulse_n_s(), 5.0) << written;
  }
  (void)load("My Motor K1 54 400 6-10 0.5 1.2 Two Words\n0.5 10\n1.0 0\n");
  EXPECT_EQ(load_rasp(file_).name, "My_Motor_K1");
}

TEST_F(RaspFile, MassesInGramsAndSizesInMetresAreDoubted) {
  const auto warning = [&](const std::string& head) {
    (void)load(head + "\n0.01 80\n1.6 60\n1.7 0\n");
    return load_rasp(file_).warning.value_or("");
  };
  EXPECT_EQ(warning("G80T 29 124 4-7-10 0.0574 0.1049 AT"), "");
  EXPECT_NE(warning("G80T 29 124 4-7-10 57.4 104.9 AT").find("another unit than kilograms"), std::string::npos);
  EXPECT_NE(warning("G80T 0.029 0.124 4-7-10 0.0574 0.1049 AT").find("another unit than millimetres"),
            std::string::npos);
  EXPECT_NE(warning("G80T 29 124 4-7-10 0.0000574 0.1049 AT").find("another unit than kilograms"), std::string::npos);
}

TEST_F(RaspFile, OfSeveralOfOneNameOneIsChosenByItsMakerOrItsNumber) {
  const std::string three =
      "K1 54 400 0 0.5 1.2 A\n0.5 10\n1.0 0\nK1 54 400 0 0.5 1.2 B\n0.5 20\n1.0 0\nK1 54 400 0 0.5 1.2 B\n0.5 30\n1.0 "
      "0\n";
  EXPECT_DOUBLE_EQ(load(three, "K1:A").impulse_n_s(), 5.0);
  EXPECT_DOUBLE_EQ(load(three, "K1:2").impulse_n_s(), 10.0);
  EXPECT_DOUBLE_EQ(load(three, "K1:3").impulse_n_s(), 15.0);
  expect_refused(three, 4, {"second motor called \"K1\"", "K1:A, K1:2, K1:3"}, "K1");
  expect_refused(three, 4, {"K1:A, K1:2, K1:3"}, "K1:B");
}

TEST_F(RaspFile, ALongListOfMotorsIsCutShort) {
  std::string many;
  for (int i = 0; i < 40; ++i) {
    many += "K" + std::to_string(i) + " 54 400 0 0.5 1.2 A\n0.5 10\n1.0 0\n";
  }
  expect_refused(many, 4, {"K0, K1, K2", "K11 and 28 more"});
  expect_refused(many, 1, {"no motor \"X\"", "and 28 more"}, "X");
}

TEST_F(RaspFile, OneOfRockSimIsReadToo) {
  const std::string rse =
      "<engine-database><engine-list><engine mfg=\"Team\" code=\"K500\" dia=\"54.\" len=\"400.\" initWt=\"1300.\" "
      "propWt=\"600.\" delays=\"P\"><data><eng-data t=\"0.\" f=\"0.\" m=\"600.\" cg=\"200.\"/><eng-data t=\"0.01\" "
      "f=\"500.\"/><eng-data t=\"2.\" f=\"400.\"/><eng-data t=\"2.1\" f=\"0.\"/></data></engine></engine-list>"
      "</engine-database>";
  EXPECT_NEAR(load(rse).impulse_n_s(), 2.5 + 1.99 * 450.0 + 20.0, 1e-9);
  const RaspMotor motor = load_rasp(file_);
  EXPECT_EQ(motor.name, "K500");
  EXPECT_DOUBLE_EQ(motor.curve.propellant_kg(), 0.6);
  EXPECT_DOUBLE_EQ(motor.total_kg, 1.3);
  EXPECT_DOUBLE_EQ(motor.length_m, 0.4);
  EXPECT_DOUBLE_EQ(motor.diameter_m, 0.054);
  for (const char* broken : {"<engine-database></engine-database>", "<engine-database>", "<html><body/></html>"}) {
    EXPECT_THROW((void)load(broken), text::Error) << broken;
  }
}

TEST_F(RaspFile, AThrustThatIsLeftAtATimeTooLargeForAMillisecondIsRefused) {
  expect_refused(header + "0.5 10\n1e18 4\n", 3, {"4 N", "zero"});
}

}  // namespace
}  // namespace fantail::input
