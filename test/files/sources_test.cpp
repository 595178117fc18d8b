// SPDX-License-Identifier: MIT
#include "files/sources.hpp"

#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "logs/refused.hpp"
#include "system/folder.hpp"

namespace fantail::files {
namespace {

using test::expect_refused;
using text::ErrorKind;

constexpr std::array asked{Quantity::time,      Quantity::phase,        Quantity::roll_angle,
                           Quantity::roll_rate, Quantity::canard,       Quantity::axial,
                           Quantity::height,    Quantity::second_axial, Quantity::speed};

Sources parse(const std::string& text) { return parse_columns(text, "--columns", asked); }

TEST(Sources, HaveASignAScaleAndAUnit) {
  const Sources sources = parse("time=ts:ms,axial=-Ay:g,roll_rate=0.5*gyro x:rpm,height=-2*alt:ft");
  ASSERT_EQ(sources.size(), 4U);
  EXPECT_EQ(find(sources, Quantity::time)->column, "ts");
  EXPECT_DOUBLE_EQ(find(sources, Quantity::time)->factor, 1e-3);
  EXPECT_EQ(find(sources, Quantity::axial)->column, "Ay");
  EXPECT_DOUBLE_EQ(find(sources, Quantity::axial)->factor, -9.80665);
  EXPECT_EQ(find(sources, Quantity::roll_rate)->column, "gyro x");
  EXPECT_DOUBLE_EQ(find(sources, Quantity::roll_rate)->factor, 0.5 * 2.0 * std::numbers::pi / 60.0);
  EXPECT_DOUBLE_EQ(find(sources, Quantity::height)->factor, -2.0 * 0.3048);
  EXPECT_EQ(find(sources, Quantity::speed), nullptr);
}

TEST(Sources, AreToldInWords) {
  const Sources sources = parse("time=t:ms,roll_rate=gyro:x:rad/s,canard_deg=u:deg,phase=mode");
  EXPECT_EQ(find(sources, Quantity::roll_rate)->column, "gyro:x") << "a name may contain a colon";
  EXPECT_EQ(find(sources, Quantity::phase)->unit, nullptr);
  EXPECT_EQ(in_words(sources), "time is t in ms, roll_rate is gyro:x in rad/s, canard is u in deg, phase is mode");
}

TEST(Sources, WhoseZeroIsThePadGainOneG) {
  const Sources sources = parse("axial_from_rest=a:m/s2,second_axial=b:g");
  EXPECT_DOUBLE_EQ(find(sources, Quantity::axial)->offset, 9.80665);
  EXPECT_EQ(find(sources, Quantity::second_axial)->offset, 0.0);
}

TEST(Sources, NamedWithTheUnitMayDoWithoutOneBehindTheColumn) {
  const Sources sources = parse("roll_rate_deg_s=p,time_s=t");
  EXPECT_EQ(find(sources, Quantity::roll_rate)->unit, nullptr);
  EXPECT_DOUBLE_EQ(find(sources, Quantity::roll_rate)->factor, std::numbers::pi / 180.0);
  const Source verbatim = parse_column("roll_rate_deg_s=-2*a,b:c", "--column", asked);
  EXPECT_EQ(verbatim.column, "-2*a,b:c") << "the older option has no sign, scale or unit";
}

TEST(Sources, AreRefusedWithWhatIsAllowed) {
  const auto refused = [](const std::string& text, std::initializer_list<const char*> parts) {
    expect_refused(ErrorKind::bad_configuration, parts, [&] { (void)parse(text); });
  };
  refused("axail=a:g", {"--columns axail=a:g", "unknown quantity \"axail\"", "did you mean axial?", "roll_rate"});
  refused("rol_rate=p:rad/s", {"unknown quantity \"rol_rate\"", "did you mean roll_rate?"});
  refused("axial=a", {"unit is missing", "a:m/s2", "g, ft/s2"});
  refused("roll_rate=p", {"--columns roll_rate=p", "unit is missing", "allowed: deg/s, rad/s"});
  refused("axial=a:rad/s", {"\"rad/s\" is not a unit of axial", "m/s2, g"});
  refused("roll_rate=p:rad", {"\"rad\" is not a unit of roll_rate", "deg/s, rad/s, mdeg/s, rpm, turn/s"});
  refused("time=t:d", {"\"d\"", "allowed: s, ms, us"});
  refused("time=t:s,axial", {"expected QUANTITY=COLUMN:UNIT"});
  refused("time=t:s,", {"expected QUANTITY=COLUMN:UNIT"});
  refused("axial=x*a:g", {"\"x\" is not a scale", "0.5*a"});
  refused("axial=0*a:g", {"is not a scale"});
  refused("axial=1e308*a:g", {"is not a scale", "1e12"});
  refused("axial=inf*a:g", {"is not a scale"});
  refused("time=-t:s", {"time", "backwards"});
  refused("axial=-:g", {"name of the column is missing"});
  refused("axial=a:g,axial_from_rest=b:g", {"axial appears twice"});
  expect_refused(ErrorKind::bad_configuration,
                 {"--column roll_angel_deg=phi", "unknown column", "did you mean roll_angle_deg?", "canard_deg"},
                 [] { (void)parse_column("roll_angel_deg=phi", "--column", asked); });
  refused("yaw_rate=r:deg/s", {"unknown quantity"});
}

TEST(Sources, OfTwoListsTheFirstGoesBefore) {
  const Sources both = merged(parse("axial=a:g"), parse("axial_from_rest=b:g,height=h:m"));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(find(both, Quantity::axial)->column, "a");
  EXPECT_EQ(find(both, Quantity::height)->column, "h");
}

TEST(Sources, ComeBackAsTheyWereKept) {
  const test::Folder folder;
  const Sources said =
      parse("time=t:ms,roll_rate=a \"quoted\" \\ name:rad/s,phase=mode,axial_from_rest=-2*a:g,speed_m_s=v");
  const Sources back = read_sources(folder.write("x.toml", sources_toml(said, "run.csv")), asked);
  ASSERT_EQ(back.size(), said.size());
  for (const Source& source : said) {
    const Source* const same = find(back, source.quantity);
    ASSERT_NE(same, nullptr) << source.column;
    EXPECT_EQ(same->column, source.column);
    EXPECT_EQ(same->unit, source.unit);
    EXPECT_EQ(same->factor, source.factor);
    EXPECT_EQ(same->offset, source.offset);
  }
}

}  // namespace
}  // namespace fantail::files
