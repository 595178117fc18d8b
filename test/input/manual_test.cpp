// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <fstream>

#include "input/fault_file.hpp"
#include "input/messages.hpp"
#include "input/scenario_file.hpp"
#include "input/vehicle_file.hpp"
#include "scratch_file.hpp"
#include "test.hpp"

// docs/your_rocket.md is made from the tables of fields wherever it lists fields.
namespace fantail::input {
namespace {

std::string range_of(const Allowed& allowed) {
  std::string each;
  switch (allowed.kind) {
    case FieldKind::text: each = allowed.is_list ? "texts" : "a text"; break;
    case FieldKind::file: each = "a shipped name or a path"; break;
    case FieldKind::choice:
      if (allowed.words.size() > 8) {
        each = "see below";  // a table explains each
        break;
      }
      for (const std::string_view word : allowed.words) {
        each += (each.empty() ? "`" : ", `") + std::string{word} + "`";
      }
      break;
    case FieldKind::number:
    case FieldKind::integer: each = about(allowed.range.minimum) + " … " + about(allowed.range.maximum); break;
  }
  if (allowed.is_list) {
    return (allowed.is_text() ? "" : "each ") + each;
  }
  return (allowed.most == 4 ? "four, each " : "") + each + (allowed.kind == FieldKind::integer ? ", whole" : "");
}

template <typename Thing>
std::string default_of(const Field<Thing>& field, const Thing& usual) {
  if (field.presence != Presence::may) {
    return "required";
  }
  const bool has_one = field.place.get != nullptr && !field.allowed.is_list;
  const double inside = has_one ? field.place.get(usual, 0) : std::nan("");
  if (std::isnan(inside)) {
    return "";
  }
  return field.allowed.kind == FieldKind::choice
             ? "`" + std::string{field.allowed.words[static_cast<std::size_t>(inside)]} + "`"
             : about(field.allowed.unit.in_file(inside));
}

// The unit is the end of the key.
constexpr const char* head = "| key | default | range | meaning |\n|---|---|---|---|\n";

template <typename Thing>
std::string row_of(const Field<Thing>& field, const Thing& usual, const std::string& of = {}) {
  std::string row = "| `";
  row.append(field.key).append("`").append(of).append(" | ");
  row.append(default_of(field, usual)).append(" | ").append(range_of(field.allowed)).append(" | ");
  return row.append(field.meaning).append(" |\n");
}

/// The keys that several sections have alike stand in the first of them, and by name in the others.
template <typename Thing>
std::string tables_of(std::span<const Field<Thing>> fields) {
  struct Section {
    std::string name;
    std::string rows;
    std::map<std::string, std::string> keys_as_in;
  };
  std::vector<Section> sections;
  std::map<std::string, std::string> first_with;
  for (const Field<Thing>& field : fields) {
    if (sections.empty() || sections.back().name != field.section) {
      sections.push_back({std::string{field.section}, {}, {}});
    }
    Section& section = sections.back();
    const std::string row = row_of(field, Thing{});
    const auto [first, is_new] = first_with.try_emplace(row, section.name);
    if (is_new) {
      section.rows += row;
    } else {
      std::string& keys = section.keys_as_in[first->second];
      keys += (keys.empty() ? "`" : ", `") + std::string{field.key} + "`";
    }
  }
  std::string tables;
  for (const Section& section : sections) {
    tables += section.name.empty() ? "\nAhead of all sections:\n\n" : "\n`[" + section.name + "]`\n\n";
    tables += section.rows.empty() ? "" : head + section.rows;
    for (const auto& [other, keys] : section.keys_as_in) {
      tables.append(section.rows.empty() ? "" : "\n").append("As in `[").append(other).append("]`: ");
      tables.append(keys).append(".\n");
    }
  }
  return tables + "\n";
}

std::vector<const FaultWords*> kinds_of(const FaultField& row) {
  std::vector<const FaultWords*> kinds;
  for (const FaultWords& words : fault_kinds()) {
    if (row.belongs_to(words)) {
      kinds.push_back(&words);
    }
  }
  return kinds;
}

std::string fault_tables() {
  std::string tables = "\n`[[faults]]`, as many as wanted\n\n" + std::string{head};
  std::map<std::string_view, std::string> own_keys;
  for (const FaultField& row : fault_fields()) {
    const std::vector<const FaultWords*> kinds = kinds_of(row);
    const std::string of = kinds.size() == 1 ? " of `" + std::string{kinds[0]->kind} + "`" : "";
    tables += row_of(row.field, kinds[0]->fault, of);
    for (const FaultWords* words : kinds) {
      std::string& keys = own_keys[words->kind];
      if (kinds.size() < fault_kinds().size()) {
        keys += (keys.empty() ? "`" : ", `") + std::string{row.field.key} + "`";
      }
    }
  }
  tables += "\n| `kind` | fault | its keys beside `kind` and `from_s` |\n|---|---|---|\n";
  for (const FaultWords& words : fault_kinds()) {
    tables.append("| `").append(words.kind).append("` | ").append(words.meaning);
    tables.append(" | ").append(own_keys[words.kind]).append(" |\n");
  }
  tables += "\n| `device` | `behaviour` | what it does |\n|---|---|---|\n";
  for (std::size_t i = 0; i < device_faults().size(); ++i) {
    const FaultWords& words = device_faults()[i];
    tables.append("| `").append(name(words.fault.device)).append("` | `").append(words.behaviour).append("`");
    const auto is_alike = [&](const FaultWords& next) {
      return next.fault.device == words.fault.device && next.meaning == words.meaning;
    };
    while (i + 1 < device_faults().size() && is_alike(device_faults()[i + 1])) {
      tables.append(", `").append(device_faults()[++i].behaviour).append("`");
    }
    tables.append(" | ").append(words.meaning).append(" |\n");
  }
  return tables + "\n";
}

// An end tells the two words of one fault apart: a servo that is stuck for good is a canard_stuck.
TEST(FaultWords, AreThoseOfTheFaultThatIsReadByThem) {
  for (const FaultWords& words : device_faults()) {
    EXPECT_EQ(&words_of(words.fault), &words) << name(words.fault.device) << ' ' << words.behaviour;
  }
  for (const FaultWords& words : fault_kinds()) {
    EXPECT_TRUE(words.kind == "device" || &words_of(words.fault) == &words) << words.kind;
  }
}

std::string page() {
  std::ifstream stream{ROCKET_MANUAL};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

// The page with what stands between the two marks of a name replaced.
std::string with(std::string text, const std::string& name, const std::string& tables) {
  const std::string begin = "<!-- fields of a " + name + " -->\n";
  const std::size_t from = text.find(begin) + begin.size();
  const std::size_t to = text.find("<!-- end of fields -->\n", from);
  if (from < begin.size() || to == std::string::npos) {
    throw std::runtime_error{"docs/your_rocket.md has lost its marks of the fields of a " + name};
  }
  return text.replace(from, to - from, tables);
}

TEST(RocketManual, ListsEveryFieldWithUnitDefaultRangeAndMeaning) {
  const std::string made = with(with(with(page(), "scenario", tables_of(scenario_fields())), "fault", fault_tables()),
                                "vehicle", tables_of(vehicle_fields()));
  if (std::getenv("FANTAIL_WRITE_MANUAL") != nullptr) {  // NOLINT(concurrency-mt-unsafe): there is one thread
    std::ofstream{ROCKET_MANUAL} << made;
  }
  EXPECT_TRUE(page() == made)
      << "the fields have changed; bring docs/your_rocket.md up to date:\n"
         "  FANTAIL_WRITE_MANUAL=1 build/host/test/input/test_input --gtest_filter='RocketManual*'";
}

// The text of the n-th block of TOML.
std::string example(std::size_t n) {
  const std::string text = page();
  const std::string begin = "```toml\n";
  std::size_t from = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    from = text.find(begin, from) + begin.size();
  }
  return text.substr(from, text.find("```\n", from) - from);
}

// What is to be copied together goes together: mounting as the plan has it without a word, no fault, no leaning guide.
TEST(RocketManual, HasExamplesThatCanBeCopied) {
  const ScratchFile scenario_file{example(0), "my_scenario.toml"};
  const std::filesystem::path folder = scenario_file.path().parent_path();
  std::ofstream{folder / "my_vehicle.toml"} << example(2);
  const std::ofstream every_default{folder / "my_plan.toml"};
  const sim::Scenario scenario = load_scenario(scenario_file.path(), {});
  EXPECT_EQ(scenario.vehicle.name, "My rocket");
  EXPECT_TRUE(scenario.faults.empty());
  EXPECT_EQ(scenario.guide.tilt_rad, 0.0);
  for (std::size_t i = 0; i < scenario.vehicle.canards.size(); ++i) {
    const core::CanardPlan& planned = scenario.plan.canards.each[i];
    const sim::CanardMounting& built = scenario.vehicle.canards[i];
    EXPECT_EQ(built.reversed, planned.direction == core::Direction::reversed);
    EXPECT_EQ(built.trim_rad, static_cast<double>(planned.trim.radians()));
    EXPECT_EQ(built.encoder_zero_rad, static_cast<double>(planned.encoder_zero.radians()));
  }
}

TEST(RocketManual, HasAFaultAndAMountingThatCanBeAdded) {
  const ScratchFile scenario_file{example(0) + example(1), "my_scenario.toml"};
  const std::filesystem::path folder = scenario_file.path().parent_path();
  std::ofstream{folder / "my_vehicle.toml"} << example(2) << example(3);
  const std::ofstream every_default{folder / "my_plan.toml"};
  const sim::Scenario scenario = load_scenario(scenario_file.path(), {});
  EXPECT_EQ(scenario.faults.size(), 1U);
  EXPECT_TRUE(scenario.vehicle.canards[2].reversed);
}

}  // namespace
}  // namespace fantail::input
