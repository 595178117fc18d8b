// SPDX-License-Identifier: MIT
#include "campaign/spread.hpp"

#include <string>

#include <gtest/gtest.h>

#include "spread_files.hpp"
#include "text/error.hpp"

namespace fantail::campaign {
namespace {

/// What is said of a spread, from the word behind its file on.
std::string refusal(const std::string& table) {
  try {
    (void)spreads_of(table);
  } catch (const text::Error& error) {
    const std::string said = error.what();
    const std::size_t file = said.find("spread.toml:");
    return file == std::string::npos ? said : said.substr(file);
  }
  return "it was taken";
}

TEST(Spreads, AreReadWithWhatTheFilesSayInTheirMiddle) {
  const auto spreads = spreads_of(R"(
[[spread]]
field = "body.roll_inertia_kg_m2"
law = "normal"
standard_deviation = 0.0002

[[spread]]
field = "disturbance.angles_deg"
law = "triangular"
effect = "factor"
low = 0.5
mode = 1
high = 2
outside = "truncate"
)");
  ASSERT_EQ(spreads.size(), 2U);
  EXPECT_EQ(spreads[0].means, std::vector{0.00393});
  EXPECT_EQ(spreads[0].outside, Outside::refuse);
  EXPECT_EQ(spreads[1].effect, Effect::factor);
  EXPECT_EQ(spreads[1].fields.front().values, (std::vector{-4.9, -5.1}));
  EXPECT_EQ(spreads_of("").size(), 0U);
}

TEST(Spreads, OfTheNextRowNeedThreeRows) {
  const input::ScratchFile two{"alpha\n20\n22\n", "two_rows.csv"};
  const std::string said = refusal("[[spread]]\nfield = \"aerodynamics.damping_m2\"\nlaw = \"next_row\"\ntable = \"" +
                                   two.path().string() + "\"\ncolumns = [\"alpha\"]\n");
  EXPECT_NE(said.find("two_rows.csv has 2 rows; allowed: 3 or more with law = \"next_row\""), std::string::npos)
      << said;
}

TEST(Spreads, ThatAreNoneAreRefusedByWhatIsWrong) {
  EXPECT_EQ(refusal("[[spread]]\nfield = \"body.mass\"\nlaw = \"uniform\"\nlow = 3\nhigh = 4\n"),
            "spread.toml:7: spread.field = \"body.mass\": unknown key body.mass; did you mean body.mass_kg?");
  EXPECT_EQ(refusal("[[spread]]\nfield = \"body.mass_kg\"\nlaw = \"normal\"\n"),
            "spread.toml:6: spread.standard_deviation is missing; allowed: 0 to 1e+300");
  EXPECT_EQ(refusal("[[spread]]\nfield = \"body.mass_kg\"\nlaw = \"uniform\"\nlow = 4\nhigh = 4\n"),
            "spread.toml:10: spread.high = 4 must be more than low = 4");
  EXPECT_EQ(refusal("[[spread]]\nfield = \"disturbance.angles_deg\"\nlaw = \"uniform\"\nlow = 3\nhigh = 4\n"),
            "spread.toml:6: spread.effect must be offset or factor: disturbance.angles_deg has 2 values");
  EXPECT_EQ(refusal("[[spread]]\nlaw = \"uniform\"\nlow = 3\nhigh = 4\n"),
            "spread.toml:6: spread.field is missing; allowed: section.key, or several of them as a list in fields");
  EXPECT_EQ(refusal("[spread]\nlaw = \"uniform\"\n"), "spread.toml:6: spread must be written as [[spread]]");
  const std::string mass = "[[spread]]\nfield = \"body.mass_kg\"\nlaw = \"uniform\"\nlow = 3\nhigh = 4\n";
  EXPECT_EQ(refusal(mass + mass), "spread.toml:12: spread.field = \"body.mass_kg\" is drawn by two spreads");
  EXPECT_EQ(refusal(mass + "sigma = 2\n").substr(0, 43), "spread.toml:11: unknown key spread.sigma; a");
}

TEST(Spreads, WithCorrelationsThatNoQuantitiesHaveAreRefused) {
  const std::string three =
      "[[spread]]\nfields = [\"aerodynamics.damping_m2\", \"aerodynamics.torque_m\", \"body.mass_kg\"]\n"
      "law = \"normal\"\nstandard_deviations = [2, 1, 0.1]\ncorrelations = ";
  EXPECT_EQ(refusal(three + "[0.9, 0.9, 0.9]\n"), "it was taken");
  EXPECT_NE(refusal(three + "[0.9, 0.9, -0.9]\n").find("contradict each other"), std::string::npos);
  EXPECT_NE(refusal(three + "[0.9]\n").find("has 1 values; allowed: 3"), std::string::npos);
}

}  // namespace
}  // namespace fantail::campaign
