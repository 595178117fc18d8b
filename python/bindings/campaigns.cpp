// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "campaign/campaign.hpp"
#include "campaign/results.hpp"
#include "campaign/setup.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "python/bindings/bind.hpp"
#include "text/error.hpp"
#include "text/output_folder.hpp"

namespace nb = nanobind;

namespace fantail::python {
namespace {

/// What campaign() in Python has arguments for.
struct CampaignRequest {
  std::string scenario;
  std::vector<std::string> changes;
  std::uint64_t runs = 0;
  std::optional<std::uint64_t> seed;
  std::string sampling;
  std::string share;
  std::optional<double> at_least;
  std::optional<double> until_within;
  bool until_decided = false;
  std::pair<std::uint64_t, std::uint64_t> shard;
  unsigned threads = 0;
  std::string out;
};

/// Its runs, and of a whole one what summary.json says.
struct FlownRuns {
  campaign::FlownCampaign flown;
  std::optional<std::string> summary;
};

campaign::Campaign campaign_of(const CampaignRequest& asked) {
  if (const std::string objection = campaign::objection_to_sampling(asked.sampling); !objection.empty()) {
    throw text::Error{text::ErrorKind::usage, objection};
  }
  campaign::Campaign campaign{.scenario = asked.scenario,
                              .changes = input::parse_overrides(asked.changes),
                              .seed = asked.seed ? *asked.seed : campaign::seed_of(asked.scenario),
                              .runs = asked.runs,
                              .shard = {.number = asked.shard.first, .of = asked.shard.second}};
  if (asked.until_within || asked.until_decided) {
    campaign.stop = campaign::StopRule{.question = campaign::parse_question(asked.share),
                                       .within = asked.until_within,
                                       .required = asked.until_decided ? asked.at_least : std::nullopt};
  }
  return campaign;
}

FlownRuns fly_campaign(const CampaignRequest& asked) {
  const campaign::Campaign campaign = campaign_of(asked);
  const campaign::Question question = campaign::parse_question(asked.share);
  const nb::gil_scoped_release others_may_work;
  FlownRuns runs;
  runs.flown = campaign::fly_campaign(campaign, asked.out, FANTAIL_VERSION, asked.threads,
                                      [](std::uint64_t) { give_up_if_interrupted(); });
  if (campaign.shard.of == 1) {
    const result::Document document = campaign::answer(
        campaign::conclude(campaign, runs.flown, question, asked.at_least,
                           result::Made{.version = FANTAIL_VERSION, .seed = campaign.seed, .changes = asked.changes},
                           asked.out, give_up_if_interrupted));
    text::OutputFolder{asked.out, {input::find_input(input::Shipped::scenario, campaign.scenario)}}.write(
        result::files(document, "summary", "campaign"));
    runs.summary = result::json(document);
  }
  return runs;
}

/// Of a drawn quantity or a figure, NaN where a run has none.
nb::ndarray<nb::numpy, const double, nb::ndim<1>> numbers_of(const FlownRuns& runs, const std::string& name) {
  const auto& quantities = runs.flown.quantities;
  const auto quantity = std::ranges::find(quantities, name);
  const auto figure = std::ranges::find(campaign::figure_columns, name);
  std::vector<double> values;
  for (const campaign::FlownRun& run : runs.flown.runs) {
    if (quantity != quantities.end()) {
      values.push_back(run.numbers[static_cast<std::size_t>(quantity - quantities.begin())]);
    } else if (figure != campaign::figure_columns.end()) {
      values.push_back(run.figures[static_cast<std::size_t>(figure - campaign::figure_columns.begin())].value_or(
          std::numeric_limits<double>::quiet_NaN()));
    } else {
      throw nb::key_error(name.c_str());
    }
  }
  return column_of<double>(std::move(values));
}

template <typename T>
nb::ndarray<nb::numpy, const T, nb::ndim<1>> whole_numbers_of(const FlownRuns& runs, T campaign::FlownRun::* member) {
  std::vector<T> values;
  std::ranges::transform(runs.flown.runs, std::back_inserter(values), member);
  return column_of<T>(std::move(values));
}

std::vector<std::string> words_of(const FlownRuns& runs, std::string campaign::FlownRun::* member) {
  std::vector<std::string> words;
  std::ranges::transform(runs.flown.runs, std::back_inserter(words), member);
  return words;
}

std::uint64_t merge_shards(const std::vector<std::string>& shards, const std::string& out) {
  const std::vector<std::filesystem::path> folders{shards.begin(), shards.end()};
  return campaign::merge(folders, out);
}

}  // namespace

void bind_campaigns(nb::module_& m) {
  using campaign::FlownRun;
  nb::class_<CampaignRequest>(m, "CampaignRequest")
      .def(nb::init<>())
      .def_rw("scenario", &CampaignRequest::scenario)
      .def_rw("changes", &CampaignRequest::changes)
      .def_rw("runs", &CampaignRequest::runs)
      .def_rw("seed", &CampaignRequest::seed, nb::arg().none())
      .def_rw("sampling", &CampaignRequest::sampling)
      .def_rw("share", &CampaignRequest::share)
      .def_rw("at_least", &CampaignRequest::at_least, nb::arg().none())
      .def_rw("until_within", &CampaignRequest::until_within, nb::arg().none())
      .def_rw("until_decided", &CampaignRequest::until_decided)
      .def_rw("shard", &CampaignRequest::shard)
      .def_rw("threads", &CampaignRequest::threads)
      .def_rw("out", &CampaignRequest::out);
  auto bound_flown = nb::class_<FlownRuns>(m, "FlownRuns")
                         .def_ro("summary", &FlownRuns::summary)
                         .def_prop_ro("remark", [](const FlownRuns& runs) { return runs.flown.remark; })
                         .def_prop_ro("quantities", [](const FlownRuns& runs) { return runs.flown.quantities; })
                         .def_prop_ro("figures",
                                      [](const FlownRuns&) {
                                        return std::vector<std::string>(campaign::figure_columns.begin(),
                                                                        campaign::figure_columns.end());
                                      })
                         .def("__len__", [](const FlownRuns& runs) { return runs.flown.runs.size(); })
                         .def("numbers", &numbers_of, nb::arg("name"))
                         .def("runs", [](const FlownRuns& runs) { return whole_numbers_of(runs, &FlownRun::run); })
                         .def("seeds", [](const FlownRuns& runs) { return whole_numbers_of(runs, &FlownRun::seed); })
                         .def("outcomes", [](const FlownRuns& runs) { return words_of(runs, &FlownRun::outcome); })
                         .def("notes", [](const FlownRuns& runs) { return words_of(runs, &FlownRun::note); });
  refuse_to_pickle(bound_flown, "Campaign", "pass to_pandas(), or its folder, and read runs.csv.gz there");
  m.def("fly_campaign", &fly_campaign, nb::arg("request"));
  m.def("merge_shards", &merge_shards, nb::arg("shards"), nb::arg("out"), nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace fantail::python
