// SPDX-License-Identifier: MIT
#include "live/panel.hpp"

#include <array>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "live/assets.hpp"
#include "page/assets.hpp"
#include "page/page.hpp"

namespace fantail::live {

namespace {

// One page: its HTML with {names} in it up to where it ends as every live page does, and the style and script that it
// has beside those of every live page.
struct Frame {
  std::string_view html;
  std::string_view css;
  std::string_view more_css;
  std::string_view js;
};

std::string filled(const Frame& frame, const PanelWords& words) {
  const std::array<std::pair<std::string_view, std::string>, 7> parts{
      {{"{source}", page::escape_html(words.source)},
       {"{command}", page::escape_html(words.command)},
       {"{version}", page::escape_html(words.version)},
       {"{css}", fmt::format("{}{}{}{}", page::chart_css, page::uplot_css, frame.css, frame.more_css)},
       {"{uplot_licence}", std::string{page::uplot_licence}},
       {"{uplot}", std::string{page::uplot_js}},
       {"{js}", std::string{page::plot_frame_js}.append(live_js).append(frame.js)}}};
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
  return page;
}

}  // namespace

std::string panel(const PanelWords& words) {
  return filled({.html = panel_html, .css = panel_css, .more_css = {}, .js = panel_js}, words);
}

std::string sheet_panel(const PanelWords& words) {
  return filled({.html = sheet_html, .css = page::page_css, .more_css = sheet_css, .js = sheet_js}, words);
}

}  // namespace fantail::live
