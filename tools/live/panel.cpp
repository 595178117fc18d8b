// SPDX-License-Identifier: MIT
#include "live/panel.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "live/assets.hpp"
#include "page/assets.hpp"
#include "page/page.hpp"

namespace fantail::live {

std::string panel(const PanelWords& words) {
  const std::array<std::pair<std::string_view, std::string>, 7> parts{
      {{"{source}", page::escape_html(words.source)},
       {"{command}", page::escape_html(words.command)},
       {"{version}", page::escape_html(words.version)},
       {"{css}", std::string{page::chart_css} + std::string{page::uplot_css} + std::string{panel_css}},
       {"{uplot_licence}", std::string{page::uplot_licence}},
       {"{uplot}", std::string{page::uplot_js}},
       {"{js}", std::string{page::plot_frame_js} + std::string{panel_js}}}};
  // One pass: what is put in is not looked at again.
  std::string page;
  std::string_view rest = panel_html;
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

}  // namespace fantail::live
