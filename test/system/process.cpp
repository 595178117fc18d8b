// SPDX-License-Identifier: MIT
#include "system/process.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fantail::test {
namespace {

constexpr unsigned patience_s = 240;

struct Pipe {
  int read_end = -1;
  int write_end = -1;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error{"no pipe"};
  }
  return {ends[0], ends[1]};
}

Pipe make_terminal() {
  Pipe terminal;
  if (openpty(&terminal.read_end, &terminal.write_end, nullptr, nullptr, nullptr) != 0) {
    throw std::runtime_error{"no terminal"};
  }
  return terminal;
}

[[noreturn]] void become(const std::string& program, const std::vector<std::string>& arguments,
                         const Surroundings& surroundings, int out, int err) {
  dup2(open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  for (int other = STDERR_FILENO + 1; other < 64; ++other) {
    close(other);
  }
  if (!surroundings.working_folder.empty() && chdir(surroundings.working_folder.c_str()) != 0) {
    _exit(126);
  }
  if (surroundings.prepare) {
    surroundings.prepare();
  }
  std::vector<char*> words;
  words.push_back(const_cast<char*>(program.c_str()));
  for (const std::string& argument : arguments) {
    words.push_back(const_cast<char*>(argument.c_str()));
  }
  words.push_back(nullptr);
  alarm(patience_s);
  execvp(program.c_str(), words.data());
  _exit(127);
}

// Until every writer has closed. A terminal whose last writer has gone answers EIO.
void drain(std::array<Pipe, 2>& from, std::array<std::string*, 2> into, std::atomic<bool>* has_spoken) {
  std::array<pollfd, 2> waiting{{{from[0].read_end, POLLIN, 0}, {from[1].read_end, POLLIN, 0}}};
  std::array<char, 65536> buffer{};
  while (waiting[0].fd >= 0 || waiting[1].fd >= 0) {
    if (poll(waiting.data(), waiting.size(), -1) < 0 && errno != EINTR) {
      throw std::runtime_error{"poll"};
    }
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (waiting[i].fd < 0 || waiting[i].revents == 0) {
        continue;
      }
      const ssize_t count = read(waiting[i].fd, buffer.data(), buffer.size());
      if (count > 0) {
        into[i]->append(buffer.data(), static_cast<std::size_t>(count));
        if (i == 1 && has_spoken != nullptr) {
          *has_spoken = true;
        }
      } else if (count == 0 || errno != EINTR) {
        close(waiting[i].fd);
        waiting[i].fd = -1;
      }
    }
  }
}

}  // namespace

std::string fantail_path() { return FANTAIL_PROGRAM; }

Outcome run(const std::string& program, const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  std::array<Pipe, 2> pipes{make_pipe(), surroundings.terminal ? make_terminal() : make_pipe()};
  const pid_t process = fork();
  if (process < 0) {
    throw std::runtime_error{"no process"};
  }
  if (process == 0) {
    become(program, arguments, surroundings, pipes[0].write_end, pipes[1].write_end);
  }
  close(pipes[0].write_end);
  close(pipes[1].write_end);

  Outcome outcome;
  std::thread companion;
  if (surroundings.meanwhile) {
    companion = std::thread{surroundings.meanwhile, process};
  }
  drain(pipes, {&outcome.out, &outcome.err}, surroundings.has_spoken);
  // Reaped only after the companion has gone: until then its number still belongs to the program.
  if (companion.joinable()) {
    companion.join();
  }
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) {
    outcome.exit_code = WEXITSTATUS(status);
  } else {
    outcome.signal = WTERMSIG(status);
  }
  return outcome;
}

Outcome fantail(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  return run(fantail_path(), arguments, surroundings);
}

std::function<void()> redirect(int stream, const std::string& file) {
  return [stream, file] {
    const int opened = open(file.c_str(), O_WRONLY | O_CREAT, 0666);
    dup2(opened, stream);
    close(opened);
  };
}

}  // namespace fantail::test
