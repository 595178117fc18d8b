// SPDX-License-Identifier: MIT
#include "input/plan_file.hpp"

#include <charconv>
#include <fstream>
#include <iomanip>

#include "core/flight_plan_fields.hpp"
#include "scratch_file.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::input {
namespace {

using core::FieldKind;
using core::Microseconds;
using core::PlanField;

core::FlightPlan plan_of(std::string_view content, const std::vector<std::string>& changes = {}) {
  const ScratchFile file{content};
  Document document = Document::load(file.path());
  for (const std::string& change : changes) {
    document.apply(parse_override(change));
  }
  return read_plan(document);
}

std::string refusal(std::string_view content, const std::vector<std::string>& changes = {}) {
  const Complaint refused = complaint([&] { (void)plan_of(content, changes); });
  EXPECT_EQ(refused.fault, text::ErrorKind::bad_configuration);
  return refused.message;
}

// As a person writes it: the shortest decimal of the float, in which 0.1F is 0.1.
std::string decimal(float value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string line(const PlanField& field, const std::string& value) {
  std::string text{"["};
  text.append(field.section).append("]\n").append(field.key).append(" = ");
  return field.is_list() ? text.append("[").append(value).append("]\n") : text.append(value).append("\n");
}

// The text that every kind of field shows for one of its values.
std::string text_of(const PlanField& field, float value) {
  switch (field.kind) {
    case FieldKind::choice: return std::string{"'"}.append(field.choices[static_cast<std::size_t>(value)]).append("'");
    case FieldKind::flag: return value != 0.0F ? "true" : "false";
    case FieldKind::integer: return std::to_string(static_cast<int>(value));
    case FieldKind::number: break;
  }
  return decimal(value);
}

bool same(const core::FlightPlan& a, const core::FlightPlan& b) {
  for (const PlanField& field : core::flight_plan_fields()) {
    if (field.used_slots(a) != field.used_slots(b)) {
      return false;
    }
    for (std::size_t slot = 0; slot < field.used_slots(a); ++slot) {
      if (field.get_bits(a, slot) != field.get_bits(b, slot)) {
        return false;
      }
    }
  }
  return true;
}

TEST(PlanFile, AnEmptyFileIsTheDefaultPlan) { EXPECT_TRUE(same(plan_of(""), core::default_plan())); }

TEST(PlanFile, EveryFieldTakesItsEndsAsAPersonWritesThemAndNothingBeyond) {
  for (const PlanField& field : core::flight_plan_fields()) {
    for (const float end : {field.minimum, field.maximum}) {
      const std::string text = line(field, text_of(field, end));
      try {
        const core::FlightPlan plan = plan_of(text);
        EXPECT_FLOAT_EQ(field.get(plan, 0), end) << text;
      } catch (const text::Error& error) {
        // Only a rule across fields may refuse an end of a range.
        EXPECT_EQ(std::string{error.what()}.find("out of range"), std::string::npos) << error.what();
      }
    }
    if (field.kind == FieldKind::number) {
      const float beyond = (field.maximum - field.minimum) * 1e-3F;
      for (const float outside : {field.minimum - beyond, field.maximum + beyond}) {
        std::ostringstream expected;
        expected << "plan.toml:2: " << field.section << '.' << field.key << " = " << decimal(outside)
                 << " is out of range; allowed: " << decimal(field.minimum) << " to " << decimal(field.maximum);
        EXPECT_EQ(refusal(line(field, decimal(outside))), expected.str());
      }
    }
  }
}

TEST(PlanFile, NoFieldTakesANotANumberOrAnotherType) {
  for (const PlanField& field : core::flight_plan_fields()) {
    for (const std::string value : {"nan", "-inf", "{x = 1}", "2015-12-04", "[[1]]"}) {
      EXPECT_TRUE(refusal(line(field, value)).starts_with("plan.toml:2: ")) << field.key << " = " << value;
    }
    if (field.kind != FieldKind::choice) {
      EXPECT_TRUE(refusal(line(field, "'six'")).starts_with("plan.toml:2: ")) << field.key;
    }
  }
}

TEST(PlanFile, AValueThatBelongsToTheWholeRocketIsNotAList) {
  EXPECT_EQ(refusal("[controller]\ncanard_limit_deg = [6]"),
            "plan.toml:2: controller.canard_limit_deg = [ 6 ] is not a number; allowed: 0.5 to 20");
  EXPECT_EQ(refusal("[controller]\ncanard_limit_deg = []"),
            "plan.toml:2: controller.canard_limit_deg = [] is not a number; allowed: 0.5 to 20");
}

TEST(PlanFile, ACanardFieldTakesOneValueForAllOrFour) {
  const core::FlightPlan one = plan_of("[canards]\ntrim_deg = 2\ndirection = \"reversed\"");
  for (const core::CanardPlan& canard : one.canards.each) {
    EXPECT_EQ(canard.trim, core::Angle::from_degrees(2.0F));
    EXPECT_EQ(canard.direction, core::Direction::reversed);
  }
  const core::FlightPlan four =
      plan_of("[canards]\ntrim_deg = [1, -2, 3, -4]\ndirection = [\"normal\", \"reversed\", \"normal\", \"reversed\"]");
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const float trim_deg = static_cast<float>(i + 1) * (i % 2 == 0 ? 1.0F : -1.0F);
    EXPECT_EQ(four.canards.each[i].trim, core::Angle::from_degrees(trim_deg));
    EXPECT_EQ(four.canards.each[i].direction, i % 2 == 0 ? core::Direction::normal : core::Direction::reversed);
  }
}

TEST(PlanFile, ACanardFieldRefusesEveryOtherNumberOfValues) {
  for (const std::string list : {"[]", "[1]", "[1, 2, 3]"}) {
    EXPECT_TRUE(refusal("[canards]\ntrim_deg = " + list).ends_with("values; allowed: one for all, or 4"))
        << refusal("[canards]\ntrim_deg = " + list);
  }
  EXPECT_EQ(refusal("[canards]\ntrim_deg = [1, 2, 3]"),
            "plan.toml:2: canards.trim_deg has 3 values; allowed: one for all, or 4");
  EXPECT_EQ(refusal("[canards]\ntrim_deg = [1, 2, 3, 4, 5]"),
            "plan.toml:2: canards.trim_deg has 5 values; allowed: one for all, or 4");
  EXPECT_EQ(refusal("[canards]\ntrim_deg = [1, 2, 3, 9]"),
            "plan.toml:2: canards.trim_deg = 9 is out of range; allowed: -5 to 5");
}

TEST(PlanFile, UnknownKeysAndSectionsAreRefusedWithASuggestion) {
  EXPECT_EQ(refusal("[controller]\ncanard_limit = 6"),
            "plan.toml:2: unknown key controller.canard_limit; did you mean controller.canard_limit_deg?");
  EXPECT_EQ(refusal("\n[controler]\n"), "plan.toml:2: unknown section [controler]; did you mean controller?");
  EXPECT_EQ(refusal("kp = 1"),
            "plan.toml:1: unknown key kp; allowed: run, sensors, launch_detection, guide, dormancy, motion, "
            "controller, gain_schedule, "
            "offset, roll_model, reference, excitation, canards, monitor, recording");
}

TEST(PlanFile, ASensorWhoseTwoAxesAreTheSameOneIsRefused) {
  EXPECT_EQ(refusal("[sensors]\nimu_to_nose = \"-y\""),
            "plan.toml:1: sensors.imu_along_y = \"+y\" is refused: must be another axis than the one that points to "
            "the nose");
  EXPECT_EQ(refusal("[sensors]\naccelerometer_to_nose = \"+z\"\naccelerometer_along_y = \"-z\""),
            "plan.toml:3: sensors.accelerometer_along_y = \"-z\" is refused: must be another axis than the one that "
            "points to the nose");
}

TEST(PlanFile, RulesAcrossFieldsNameTheFieldItsLineAndTheRule) {
  EXPECT_EQ(refusal("[reference]\nkind = \"steps\""),
            "plan.toml:1: reference.step_times_s is refused: kind = \"steps\" needs at least one step");
  EXPECT_EQ(
      refusal("[reference]\nstep_times_s = [1, 2]\nstep_angles_deg = [1]"),
      "plan.toml:2: reference.step_times_s is refused: step_times_s and step_angles_deg must have the same length");
  EXPECT_EQ(refusal("[reference]\nstep_times_s = [2, 1]\nstep_angles_deg = [1, 2]"),
            "plan.toml:2: reference.step_times_s = 1 is refused: step times must increase");
  EXPECT_EQ(refusal("[controller]\ncanard_limit_deg = 4\n[canards]\ntrim_deg = [0, 0, -4, 0]"),
            "plan.toml:4: canards.trim_deg = -4 is refused: must lie inside controller.canard_limit_deg");
}

TEST(PlanFile, OverridesWinAndAreNamedInEveryRefusal) {
  EXPECT_EQ(plan_of("[controller]\ncanard_limit_deg = 6", {"controller.canard_limit_deg=7.5"}).controller.canard_limit,
            core::Angle::from_degrees(7.5F));
  EXPECT_EQ(plan_of("", {"excitation.form=product"}).excitation.form, core::ExcitationForm::product);
  EXPECT_EQ(plan_of("", {"launch_detection.low_pass=false"}).launch_detection.low_pass, false);
  EXPECT_EQ(plan_of("", {"canards.trim_deg=[1, 2, 3, 4]"}).canards.each[2].trim, core::Angle::from_degrees(3.0F));
  EXPECT_EQ(
      refusal("[controller]\ncanard_limit_deg = 6", {"controller.canard_limit_deg=30"}),
      "--set controller.canard_limit_deg=30: controller.canard_limit_deg = 30 is out of range; allowed: 0.5 to 20");
  EXPECT_EQ(refusal("", {"controller.kp=1"}),
            "--set controller.kp=1: unknown key controller.kp; allowed: proportional_gain, derivative_gain_s, "
            "rate_reference, canard_limit_deg, entry");
  EXPECT_EQ(refusal("", {"contoller.x=1"}),
            "--set contoller.x=1: unknown section [contoller]; did you mean controller?");
  EXPECT_EQ(refusal("", {"excitation.form=chirp"}),
            "--set excitation.form=chirp: excitation.form = 'chirp'; allowed: none, product, sweep");
  EXPECT_EQ(refusal("[excitation]\nform = \"product\"", {"excitation.end_s=0.3"}),
            "--set excitation.end_s=0.3: excitation.end_s = 0.3 is refused: must be later than begin_s");
  EXPECT_EQ(refusal("[excitation]\nend_s = nan", {"excitation.end_s=nan"}),
            "--set excitation.end_s=nan: excitation.end_s = nan is out of range; allowed: 0 to 600");
}

TEST(PlanFile, EveryMillisecondOfTenMinutesIsKeptExactly) {
  const ScratchFile file{""};
  Document document = Document::load(file.path());
  for (const std::int64_t ms : {1L, 700L, 8001L, 77'800L, 123'457L, 300'001L, 599'999L, 600'000L}) {
    document.apply({"reference", "square_wave_begin_s", std::to_string(static_cast<double>(ms) / 1000.0)});
    EXPECT_EQ(read_plan(document).reference.square_wave_begin, Microseconds{ms * 1000});
  }
}

TEST(PlanFile, TheTableOfAPlanReadsBackAsThePlan) {
  const core::FlightPlan plan = plan_of(
      "[run]\ncontrol_time_s = 123.456\n[canards]\ntrim_deg = [1, -2.5, 0.1, 0]\ndirection = [\"normal\", "
      "\"reversed\", "
      "\"normal\", \"normal\"]\nencoder_zero_deg = 179.98\n[reference]\nkind = \"steps\"\nstep_times_s = [1, "
      "300.001]\nstep_angles_deg = [-20, 33.3]\n[excitation]\nvariation_seed = 16777215\n");
  EXPECT_TRUE(same(plan_of(plan_table(plan)), plan)) << plan_table(plan);
  EXPECT_TRUE(same(plan_of(plan_table(core::default_plan())), core::default_plan()));
}

// One random value of a field, in the digits that a person might write.
std::string random_value(const PlanField& field, std::mt19937& random) {
  if (field.kind != FieldKind::number) {
    std::uniform_int_distribution<int> whole{static_cast<int>(field.minimum), static_cast<int>(field.maximum)};
    return text_of(field, static_cast<float>(whole(random)));
  }
  std::uniform_real_distribution<double> within{field.minimum, field.maximum};
  std::ostringstream text;
  text << std::setprecision(std::uniform_int_distribution<int>{1, 12}(random)) << within(random);
  return text.str();
}

TEST(PlanFile, EveryValueOfAFileIsShownSoThatItReadsBackBitForBit) {
  std::mt19937 random{test::seed()};
  int read = 0;
  for (const PlanField& field : core::flight_plan_fields()) {
    for (int i = 0; i < 8; ++i) {
      const std::string text = line(field, random_value(field, random));
      std::optional<core::FlightPlan> plan;
      try {
        plan = plan_of(text);
      } catch (const text::Error&) {  // rounded out of its range, or against a rule across fields
        continue;
      }
      ++read;
      ASSERT_TRUE(same(plan_of(plan_table(*plan)), *plan)) << text;
      ASSERT_TRUE(table_says_all(*plan)) << text;
    }
  }
  EXPECT_GT(read, 100);
}

// Half a degree, as no file gives it: between two singles in degrees there can be two in radians.
TEST(PlanFile, AValueThatNoFileGivesIsNoticed) {
  int noticed = 0;
  for (int i = 0; i < 100; ++i) {
    core::FlightPlan plan = core::default_plan();
    float limit = core::Angle::from_degrees(1.0F).radians();
    for (int step = 0; step < i; ++step) {
      limit = std::nextafter(limit, 1.0F);
    }
    plan.controller.canard_limit = core::Angle::from_radians(limit);
    ASSERT_EQ(table_says_all(plan), same(plan_of(plan_table(plan)), plan));
    noticed += table_says_all(plan) ? 0 : 1;
  }
  EXPECT_GT(noticed, 0);
}

// The manual is made from the table of fields like everything else.
TEST(PlanFile, TheManualHoldsTheTableOfDefaults) {
  std::ifstream stream{PLAN_MANUAL};
  const std::string manual{std::istreambuf_iterator<char>{stream}, {}};
  const std::string block = "```toml\n" + plan_table(core::default_plan()) + "```\n";
  EXPECT_TRUE(manual.ends_with(block))
      << "the fields have changed; bring docs/flight_plan.md up to date:\n"
         "  { sed '/^```toml$/q' docs/flight_plan.md; ./dev plan show; echo '```'; } > build/flight_plan.md &&"
         " mv build/flight_plan.md docs/flight_plan.md";
}

}  // namespace
}  // namespace fantail::input
