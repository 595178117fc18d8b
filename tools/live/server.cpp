// SPDX-License-Identifier: MIT
#include "live/server.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fmt/core.h>

#include "live/http_server.hpp"
#include "live/viewer.hpp"

namespace fantail::live {
namespace {

// Besides the viewers some are left for whoever asks for the page, or for what there is not.
constexpr std::size_t most_connections = Server::most_viewers + 8;
// The kernel keeps megabytes for a viewer that takes nothing, which would show it a flight that is long over.
constexpr int send_buffer_bytes = 64 * 1024;

// Scripts and styles are in the page; nothing is loaded, and no other site may show it in a frame.
constexpr const char* content_security_policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

std::string own_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? std::string{name.data()} : std::string{};
}

std::string event_of(const std::string& frame) { return "data: " + frame + "\n\n"; }

// The library's own options let two programs listen at one port, each for a part of the viewers.
void set_options(int socket) {
  constexpr int on = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  ::setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &send_buffer_bytes, sizeof send_buffer_bytes);
}

}  // namespace

struct Server::Http {
  HttpServer server{most_connections};
  Address address;
  Page page;
  std::function<std::string()> greeting;
  mutable std::mutex mutex;
  std::set<std::shared_ptr<Viewer>> viewers;
  ServerFigures figures;
  std::thread thread;

  void answer_all();
  void answer_events(httplib::Response& response);
  bool feed(const std::shared_ptr<Viewer>& viewer, httplib::DataSink& sink);
  bool write(httplib::DataSink& sink, const std::string& event);
  void leave(const std::shared_ptr<Viewer>& viewer) {
    const std::scoped_lock lock{mutex};
    viewers.erase(viewer);
    figures.viewers = viewers.size();
  }
};

void Server::Http::answer_all() {
  server.set_pre_routing_handler(
      [this, name = own_name()](const httplib::Request& request, httplib::Response& response) {
        response.set_header("Cache-Control", "no-store");
        response.set_header("Content-Security-Policy", content_security_policy);
        response.set_header("X-Content-Type-Options", "nosniff");
        response.set_header("Referrer-Policy", "no-referrer");
        if (request.method != "GET") {
          response.status = 405;
          response.set_header("Allow", "GET");
          response.set_content("This page is read-only: nothing can be sent to it.\n", "text/plain");
          return httplib::Server::HandlerResponse::Handled;
        }
        if (request.get_header_value_count("Host") != 1 || !may_ask(address, request.get_header_value("Host"), name)) {
          response.status = 403;
          response.set_content("This page is served at " + address.url() + " only.\n", "text/plain");
          return httplib::Server::HandlerResponse::Handled;
        }
        return httplib::Server::HandlerResponse::Unhandled;
      });
  server.Get("/", [this](const httplib::Request&, httplib::Response& response) {
    response.set_content(page.html, "text/html; charset=utf-8");
  });
  server.Get("/favicon.ico", [](const httplib::Request&, httplib::Response& response) { response.status = 204; });
  server.Get("/events", [this](const httplib::Request&, httplib::Response& response) { answer_events(response); });
  server.set_error_handler([](const httplib::Request&, httplib::Response& response) {
    if (response.body.empty()) {
      response.set_content("There is one page here: /\n", "text/plain");
    }
  });
}

void Server::Http::answer_events(httplib::Response& response) {
  auto viewer = std::make_shared<Viewer>(most_waiting);
  {
    const std::scoped_lock lock{mutex};
    if (viewers.size() >= most_viewers) {
      figures.refused += 1;
      response.status = 503;
      response.set_content(fmt::format("{} viewers are connected, which is the maximum.\n", most_viewers),
                           "text/plain");
      return;
    }
    viewers.insert(viewer);
    figures.viewers = viewers.size();
    figures.most_viewers = std::max(figures.most_viewers, viewers.size());
  }
  // Entered first and greeted then: a frame may come twice, and none is missed. The page knows them by their number.
  viewer->put_first(
      std::make_shared<const std::string>("event: page\ndata: " + page.about + "\n\n" + event_of(greeting())));
  response.set_chunked_content_provider(
      "text/event-stream", [this, viewer](std::size_t, httplib::DataSink& sink) { return feed(viewer, sink); },
      [this, viewer](bool) { leave(viewer); });
}

bool Server::Http::feed(const std::shared_ptr<Viewer>& viewer, httplib::DataSink& sink) {
  if (viewer->has_ended() || !sink.is_writable()) {
    return false;
  }
  const Viewer::Frame frame = viewer->take();
  // A line that begins with a colon says nothing: it finds out whether anybody is still there.
  return write(sink, frame ? *frame : ":\n\n");
}

bool Server::Http::write(httplib::DataSink& sink, const std::string& event) {
  if (!sink.write(event.data(), event.size())) {
    return false;
  }
  const std::scoped_lock lock{mutex};
  figures.frames_sent += event.starts_with(':') ? 0 : 1;
  figures.bytes_sent += event.size();
  return true;
}

Server::Server(const Address& address, Page page, std::function<std::string()> greeting)
    : http_{std::make_unique<Http>()} {
  Http& http = *http_;
  http.address = address;
  http.page = std::move(page);
  http.greeting = std::move(greeting);
  http.server.set_socket_options(set_options);
  http.server.set_payload_max_length(0);
  http.server.set_tcp_nodelay(true);
  http.answer_all();
  errno = 0;
  const int port = address.port == 0                                      ? http.server.bind_to_any_port(address.host)
                   : http.server.bind_to_port(address.host, address.port) ? address.port
                                                                          : -1;
  if (port < 0) {
    const int error = errno;
    throw std::runtime_error{
        fmt::format("{} cannot be served{}{}", address.url(), error != 0 ? ": " : "",
                    error == EADDRINUSE ? "another program uses this port; choose another one with --page-at HOST:PORT"
                    : error != 0        ? std::strerror(error)
                                        : "")};
  }
  http.address.port = port;
  http.server.let_many_wait();
  http.thread = std::thread{[&http] { http.server.listen_after_bind(); }};
  // To stop a server that does not run yet does nothing, and it would run for ever.
  while (!http.server.is_running()) {
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
}

Server::~Server() {
  {
    const std::scoped_lock lock{http_->mutex};
    for (const auto& viewer : http_->viewers) {
      viewer->end();
    }
  }
  http_->server.end();
  http_->thread.join();
}

const Address& Server::address() const { return http_->address; }

void Server::show(const std::string& frame) {
  const auto shared = std::make_shared<const std::string>(event_of(frame));
  const std::scoped_lock lock{http_->mutex};
  for (const auto& viewer : http_->viewers) {
    http_->figures.frames_dropped += viewer->put(shared) ? 1 : 0;
  }
}

ServerFigures Server::figures() const {
  const std::scoped_lock lock{http_->mutex};
  ServerFigures figures = http_->figures;
  figures.refused += http_->server.refused();
  return figures;
}

}  // namespace fantail::live
