// SPDX-License-Identifier: MIT
#include "can/rig.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace fantail::test {
namespace {

const std::string source = FANTAIL_TEST_SOURCE;
const std::string with_python = source + "/test/with_python.sh";
const std::string database = source + "/firmware/protocol/canard_bus.dbc";

std::string flash_or(const std::string& flash, const Folder& folder) {
  return flash.empty() ? folder / "flash.bin" : flash;
}

unsigned hexadecimal(const std::string& text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw std::runtime_error{"not a number: " + text};
  }
  return value;
}

// "123#DEAD01", "1ABCDEF0#42", "321#R2".
hal::CanFrame frame_of(const std::string& text) {
  const std::size_t hash = text.find('#');
  const std::string data = text.substr(hash + 1);
  hal::CanFrame frame{.id = hexadecimal(text.substr(0, hash)), .extended = hash == 8};
  if (data.starts_with('R')) {
    frame.remote = true;
    frame.length = data.size() > 1 ? static_cast<std::uint8_t>(data[1] - '0') : 0;
    return frame;
  }
  frame.length = static_cast<std::uint8_t>(data.size() / 2);
  for (std::size_t i = 0; i < frame.length; ++i) {
    frame.data[i] = static_cast<std::uint8_t>(hexadecimal(data.substr(2 * i, 2)));
  }
  return frame;
}

std::string run_can_tools(const std::vector<std::string>& arguments, const std::string& input) {
  const Folder folder;
  const std::string file = folder.write("input", input);
  std::vector<std::string> words{"-c", "file=$1; shift; exec \"$@\" <\"$file\"", "sh", file, with_python};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const Outcome outcome = run("sh", words);
  if (outcome.exit_code != 0) {
    throw std::runtime_error{"cantools: " + outcome.err};
  }
  return outcome.out;
}

// "... :: Name(one: 1 deg, two: word)"
std::optional<Spoken> spoken(const std::string& line) {
  const std::size_t begin = line.find(" :: ");
  const std::size_t open = line.find('(', begin);
  if (begin == std::string::npos || open == std::string::npos || !line.ends_with(')')) {
    return std::nullopt;
  }
  Spoken result{.name = line.substr(begin + 4, open - begin - 4), .signals = {}};
  std::istringstream signals{line.substr(open + 1, line.size() - open - 2)};
  for (std::string one; std::getline(signals, one, ',');) {
    std::istringstream words{one};
    std::string name;
    std::string value;
    words >> name >> value;
    result.signals[name.substr(0, name.size() - 1)] = value;
  }
  return result;
}

}  // namespace

bool Ear::until(const std::function<bool()>& question, std::chrono::milliseconds longest) {
  for (const auto end = clock_.now() + longest; clock_.now() < end;) {
    link_.listen(clock_.now());
    if (question()) {
      return true;
    }
    // Not at every frame: the guest has one processor, and the programs need it.
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
  return false;
}

Node::Node(const std::string& on, const std::string& scenario, const std::string& flash,
           const std::vector<std::string>& settings)
    : interface{on}, program{[&] {
        std::vector<std::string> arguments{"node", scenario, "--can", on, "--flash", flash_or(flash, folder)};
        for (const std::string& setting : settings) {
          arguments.insert(arguments.end(), {"--set", setting});
        }
        return arguments;
      }()} {}

void Node::await_rest() {
  if (!program.says(" on " + interface + ";") || !Ear{interface}.at_rest()) {
    throw std::runtime_error{"the node does not come to rest: " + program.said()};
  }
}

void AtARocket::SetUpTestSuite() {
  restore_virtual_buses();
  node = std::make_unique<Node>("vcan0");
  node->await_rest();
}

bool starved(const Outcome& outcome) {
  const bool yes = outcome.exit_code == 74 &&
                   (contains(outcome.err, "no heartbeat from the bench arrived for 0.1 s") ||
                    contains(outcome.err, "the canards are not judged") || contains(outcome.err, "no verdict: "));
  if (yes) {
    std::puts("this machine is busy: a bench had too little processor time; once more");
  }
  return yes;
}

Outcome fantail_bench(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  std::vector<std::string> words{"bench"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  Outcome outcome = fantail(words, surroundings);
  for (int again = 0; again < 11 && starved(outcome); ++again) {
    outcome = fantail(words, surroundings);
  }
  return outcome;
}

std::unique_ptr<Program> bench_until(const std::vector<std::string>& arguments,
                                     const std::function<bool(const Program&)>& question) {
  std::vector<std::string> words{"bench"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  for (int attempt = 0; attempt < 12; ++attempt) {
    auto bench = std::make_unique<Program>(words);
    bool yes = false;
    if (eventually([&] { return (yes = question(*bench)) || bench->ended(); }) && yes) {
      return bench;
    }
    bench->signal(SIGKILL);
    std::printf("a bench did not get there%s: %s\n", attempt < 11 ? ", once more" : "", bench->outcome().err.c_str());
  }
  throw std::runtime_error{"the bench never gets there"};
}

Dump::Dump(const std::string& interface)
    : interface_{interface}, program_{"candump", {"-L", "-r", "8000000", interface}} {
  hal::on_linux::CanBus bus{interface_};
  const auto heard = [&] {
    (void)bus.send({.id = 0x7FE, .length = 1});
    return program_.said().find(interface_ + " 7FE#00") != std::string::npos;
  };
  if (!eventually(heard)) {
    throw std::runtime_error{"candump does not listen to " + interface};
  }
}

// candump may lag behind; it has everything when it has this.
std::string Dump::log() {
  if (!hal::on_linux::CanBus{interface_}.send({.id = 0x7FE, .length = 2, .data = {0xF1, 0x7A}}) ||
      !program_.says(interface_ + " 7FE#F17A")) {
    throw std::runtime_error{"candump does not hear " + interface_};
  }
  program_.signal(SIGTERM);
  return program_.outcome().out;
}

std::vector<LoggedFrame> frames(const std::string& log) {
  std::vector<LoggedFrame> all;
  std::istringstream lines{log};
  std::string time;
  std::string interface;
  std::string text;
  while (lines >> time >> interface >> text) {
    if (text.find("##") == std::string::npos) {
      all.push_back({.time_s = std::stod(time.substr(1)), .frame = frame_of(text)});
    }
  }
  return all;
}

bool have_cantools() { return run(with_python, {"-c", ""}).exit_code == 0; }

std::vector<Spoken> decoded_by_cantools(const std::string& log) {
  std::istringstream lines{run_can_tools({"-m", "cantools", "decode", "--single-line", database}, log)};
  std::vector<Spoken> all;
  for (std::string line; std::getline(lines, line);) {
    if (auto one = spoken(line)) {
      all.push_back(std::move(*one));
    }
  }
  return all;
}

std::string encoded_by_cantools(const std::string& lines, const std::string& interface) {
  return run_can_tools({source + "/test/can/encode.py", database, interface}, lines);
}

float farthest_deg(const protocol::PerCanard& angles) {
  float farthest = 0.0F;
  for (const auto& angle : angles) {
    farthest = std::max(farthest, std::fabs(angle.value_or(core::Angle{}).degrees()));
  }
  return farthest;
}

}  // namespace fantail::test
