// SPDX-License-Identifier: MIT
#include "live/panel.hpp"

#include <array>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "json/value.hpp"
#include "page/page.hpp"
#include "page/parts.hpp"

namespace fantail::live {

namespace {

// One page: its HTML with {names} in it up to where it ends as every live page does, and the style and script that it
// has beside those of every live page.
struct Frame {
  std::string_view name;  ///< that its body has, too
  std::string_view title;
  std::string_view html;
  std::string_view css;
  std::string_view more_css;
  std::string_view js;
};

Page filled(const Frame& frame, const PanelWords& words) {
  const std::string title = fmt::format("{}: {}", frame.title, words.source);
  const std::array<std::pair<std::string_view, std::string>, 9> parts{
      {{"{page}", std::string{frame.name}},
       {"{title}", page::escape_html(title)},
       {"{source}", page::escape_html(words.source)},
       {"{command}", page::escape_html(words.command)},
       {"{version}", page::escape_html(words.version)},
       {"{css}", fmt::format("{}{}{}{}", page::chart_css, page::uplot_css, frame.css, frame.more_css)},
       {"{uplot_licence}", std::string{page::uplot_licence}},
       {"{uplot}", std::string{page::uplot_js}},
       {"{js}", std::string{page::plot_frame_js}.append(live_js).append(frame.js)}}};
  const json::Value about = {{"page", frame.name},
                             {"title", title},
                             {"source", words.source},
                             {"command", words.command},
                             {"version", words.version}};
  // One pass: what is put in is not looked at again.
  const std::string html = std::string{frame.html}.append(end_html);
  std::string page;
  std::string_view rest = html;
  while (!rest.empty()) {
    std::size_t at = std::string_view::npos;
    const std::pair<std::string_view, std::string>* next = nullptr;
    for (const auto& part : parts) {
      if (const std::size_t found = rest.find(part.first); found < at) {
        at = found;
        next = &part;
      }
    }
    page += rest.substr(0, at);
    if (next == nullptr) {
      break;
    }
    page += next->second;
    rest.remove_prefix(at + next->first.size());
  }
  return {.html = page, .about = about.dump()};
}

}  // namespace

Page panel(const PanelWords& words) {
  return filled(
      {.name = "rocket", .title = "Fantail live", .html = panel_html, .css = panel_css, .more_css = {}, .js = panel_js},
      words);
}

Page sheet_panel(const PanelWords& words) {
  return filled({.name = "sheet",
                 .title = "Fantail bench",
                 .html = sheet_html,
                 .css = page::page_css,
                 .more_css = sheet_css,
                 .js = sheet_js},
                words);
}

}  // namespace fantail::live
