// SPDX-License-Identifier: MIT
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "fantail/deliver.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/terminal.hpp"
#include "paper/paper_page.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

struct PaperOptions {
  std::string out = "out/paper";
  bool json = false;
};

std::vector<paper::Chapter> work_through() {
  Chapters progress{"paper", 7, "the air of the tunnel"};
  const paper::Tell tell = [&progress](const std::string& what) {
    give_up_if_interrupted();
    progress.now(what);
  };
  std::vector<paper::Chapter> chapters{paper::air_chapter(tell)};
  progress.next("the swirl of the tunnel");
  chapters.push_back(paper::swirl_chapter(tell));
  progress.next("launch 1");
  chapters.push_back(paper::first_launch_chapter(tell));
  progress.next("the steps in the tunnel");
  chapters.push_back(paper::steps_chapter(tell));
  progress.next("launch 2");
  chapters.push_back(paper::second_launch_chapter(tell));
  progress.next("checking the publication against itself");
  chapters.push_back(paper::print_chapter(paper::Print::as_published()));
  progress.next("listing inputs taken as printed");
  chapters.push_back(paper::inputs_chapter());
  return chapters;
}

void print_chapters(const std::vector<paper::Chapter>& chapters) {
  for (const paper::Chapter& chapter : chapters) {
    show("{}\n", chapter.title);
    for (const paper::Claim& claim : chapter.claims) {
      if (is_folded(claim)) {
        continue;
      }
      show("  {:<20} {}: {}\n", paper::kind_words(claim), claim.place, claim.what);
      show("  {:<20}   printed {}{}{}\n", "", claim.theirs, claim.ours.empty() ? "" : "; ours ", claim.ours);
    }
    const std::string folded = paper::folded_words(chapter.claims);
    show("{}\n", folded.empty() ? "" : "  " + folded + " (on the page and with --json)\n");
  }
}

void repeat_the_paper(const PaperOptions& options) {
  const std::vector<paper::Chapter> chapters = work_through();
  const std::string json = paper::paper_json(chapters, FANTAIL_VERSION, made_with({}));
  const std::filesystem::path folder{options.out};
  give_up_if_interrupted();
  text::OutputFolder{folder}.write(
      std::array{text::NamedFile{.name = "paper.html", .content = paper::paper_html(chapters, FANTAIL_VERSION)},
                 text::NamedFile{.name = "paper.json", .content = json}});
  if (options.json) {
    fmt::print("{}", json);
    return;
  }
  print_chapters(chapters);
  show("{}\n\n  page  {}\n", paper::summary(paper::tally(chapters)), (folder / "paper.html").string());
}

void fill(const Verb& verb) {
  auto options = std::make_shared<PaperOptions>();
  verb.option("--out", options->out, "Folder for paper.html and paper.json").offers(folders).show_default();
  verb.flag("--json", options->json, "Print paper.json instead of the text");
  verb.examples(
      "Examples:\n"
      "  fantail paper                        every printed table, figure and number beside ours, in out/paper\n"
      "  fantail paper --out /tmp/page        the page elsewhere\n"
      "  fantail paper --json | jq .differs   how many statements came out differently\n"
      "  fantail paper --json | jq .kinds     how many agree, by the source of our value");
  verb.action([options] { repeat_the_paper(*options); });
}

const VerbCode code{"paper", fill};

}  // namespace
}  // namespace fantail::tool
