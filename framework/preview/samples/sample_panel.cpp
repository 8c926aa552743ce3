#include "preview/samples/sample_panel.h"

#include "preview/marks.h"
#include "preview/panel_colours.h"
#include "preview/samples/sample_controls.h"
#include "preview/samples/sample_plot.h"
#include "preview/samples/sample_remarks.h"
#include "preview/samples/sample_verdict.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace pathmark::preview {

namespace {

void write(ImU32 colour, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void writeFound(const VerdictWords& words) {
  if (words.found.empty()) return;
  constexpr ImGuiTreeNodeFlags kOpen =
      ImGuiTreeNodeFlags_DefaultOpen | ImGuiTreeNodeFlags_NoTreePushOnOpen;
  if (!ImGui::TreeNodeEx("what was found", kOpen)) return;
  for (const CheckLine::Field& field : words.found) {
    write(kNeutralColour, field.name);
    ImGui::SameLine(6.0f * ImGui::GetFontSize());
    write(kTextColour, field.value);
  }
}

// A domain without samples.
std::shared_ptr<const SampleAnswer> emptyAnswer(const SampleSettings& settings) {
  const auto answer = std::make_shared<SampleAnswer>();
  answer->settings = answer->set.settings = settings;
  answer->set.sketch = makeSampleDomain(settings)->sketch();
  return answer;
}

}  // namespace

void SamplePanel::draw(const Frame& frame) {
  followPart(frame.part);
  chooseFunction(settings_, frame.part);
  showVerdict(frame);
  choosePoints(settings_, frame.scale);
  const auto newest = ask(frame);
  const bool fits = newest && newest->settings.function == settings_.function;
  const auto answer = fits ? newest : emptyAnswer(settings_);
  const float end = showScene(*answer, frame);
  chooseLook(*answer);
  chooseParameters(settings_, frame.scale);
  showNumbers(*answer, frame.scale);
  keepTime(frame);
  below_ = ImGui::GetCursorPosY() - end;
}

void SamplePanel::choose(CourseworkFunction function) {
  for (const SampledFunction& f : kSampledFunctions)
    if (f.function == function) settings_.function = function;
}

bool SamplePanel::busy(const Frame& frame) const {
  if (!frame.coursework->build) return false;
  const bool checked =
      frame.checks && frame.checks->finished && frame.checks->build == frame.coursework->number;
  return !checked || awaitsSamples(frame);
}

bool SamplePanel::awaitsSamples(const Frame& frame) const {
  if (!frame.coursework->build) return false;
  const auto newest = engine_ ? engine_->newest() : nullptr;
  return !newest || newest->settings != settings_ || newest->build != frame.coursework->number;
}

// To the first sampler of a part that has been chosen.
void SamplePanel::followPart(int part) {
  if (part == part_) return;
  part_ = part;
  if (contractOf(settings_.function).part == part) return;
  for (const SampledFunction& f : kSampledFunctions)
    if (contractOf(f.function).part == part) {
      settings_.function = f.function;
      return;
    }
}

std::shared_ptr<const SampleAnswer> SamplePanel::ask(const Frame& frame) {
  if (!frame.coursework->build) return nullptr;
  if (!engine_)
    engine_ = std::make_unique<SampleEngine>(frame.wake != nullptr ? *frame.wake : [] {});
  engine_->show(frame.coursework, settings_);
  return engine_->newest();
}

void SamplePanel::showVerdict(const Frame& frame) const {
  const VerdictWords words = verdictOn(settings_.function, *frame.coursework, frame.checks.get());
  const float height = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  drawMark({corner.x + 0.5f * height, corner.y + 0.5f * height}, 0.4f * height, words.outcome);
  ImGui::SetCursorScreenPos({corner.x + 1.4f * height, corner.y});
  ImGui::BeginGroup();
  write(colourOf(words.outcome), words.headline);
  writeFound(words);
  ImGui::EndGroup();
}

// Returns where the scene ends.
float SamplePanel::showScene(const SampleAnswer& answer, const Frame& frame) {
  const float width = ImGui::GetContentRegionAvail().x;
  SampleScene::Look look;
  look.colouring = colouring_;
  look.scale = frame.scale;
  // As much as is left, so that everything is in sight where that is possible.
  const float least = 200.0f * frame.scale, most = std::max(0.72f * width, least);
  look.size = {
      width, std::clamp(ImGui::GetContentRegionAvail().y - below_ - ImGui::GetStyle().ItemSpacing.y,
                        least, most)};
  look.shown = playback_.shown(answer.set.samples.size(), ImGui::GetTime());
  scene_.draw(answer.set, look);
  const float end = ImGui::GetCursorPosY();
  if (!frame.coursework->build)
    write(kNeutralColour, "The coursework is being built.");
  else if (answer.kind == SampleAnswer::Kind::kNotWritten)
    write(kNeutralColour, answer.sentence);
  else if (!answer.sentence.empty())
    write(kBadColour, answer.sentence);
  if (!answer.note.empty()) write(kBadColour, answer.note);
  return end;
}

void SamplePanel::chooseLook(const SampleAnswer& answer) {
  if (!canShow(colouring_, answer.set) && !answer.set.samples.empty())
    colouring_ = Colouring::kOrder;
  const float half = 0.5f * ImGui::GetContentRegionAvail().x;
  if (ImGui::Button(playback_.playing() ? "show all" : "show one by one")) {
    if (playback_.playing())
      playback_.stop();
    else
      playback_.start(ImGui::GetTime());
  }
  ImGui::SameLine(half);
  ImGui::SetNextItemWidth(-1.0f);
  const auto name = [](Colouring c) {
    return fmt::format("colour: {}", kColouringNames[static_cast<std::size_t>(c)]);
  };
  if (!ImGui::BeginCombo("##colour", name(colouring_).c_str())) return;
  for (std::size_t k = 0; k < kColouringNames.size(); ++k) {
    const auto c = static_cast<Colouring>(k);
    if (canShow(c, answer.set) && ImGui::Selectable(name(c).c_str(), c == colouring_))
      colouring_ = c;
  }
  ImGui::EndCombo();
}

void SamplePanel::showNumbers(const SampleAnswer& answer, float scale) {
  const SampleSet& set = answer.set;
  if (answer.kind != SampleAnswer::Kind::kSamples) return;
  if (set.claims) ImGui::Checkbox("weighted by expected / claimed", &weighted_);
  const bool weighted = weighted_ && set.claims;
  const SampleView& view = weighted ? set.weighted : set.plain;
  drawHistograms(view.histograms, set.samples.size(), scale);
  write(view.test.possible && view.test.pValue < kUnlikely ? kBadColour : kTextColour,
        describe(view.test, set.settings.points));
  write(kNeutralColour, "For the eye: the verdict above is the checks'.");
  if (set.claimedOverExpected)
    write(kTextColour, fmt::format("claimed density: {:.4g} to {:.4g}\n"
                                   "claimed / expected: {:.4g} to {:.4g}",
                                   set.claimed->low, set.claimed->high,
                                   set.claimedOverExpected->low, set.claimedOverExpected->high));
  for (const std::string& remark : remarksOn(set)) write(kTextColour, remark);
}

// Frames while samples appear, and so that a long wait is told of.
void SamplePanel::keepTime(const Frame& frame) {
  constexpr double kLong = 0.4;  // seconds
  const double now = ImGui::GetTime();
  const bool waiting = awaitsSamples(frame);
  if (!waiting)
    waitingSince_ = -1.0;
  else if (waitingSince_ < 0.0)
    waitingSince_ = now;
  if (waiting && now - waitingSince_ > kLong)
    write(kNeutralColour, "Waiting for samples of the newest version ...");
  if (!waiting && !playback_.playing())
    metronome_.reset();
  else if (!metronome_ && frame.wake != nullptr)
    metronome_.emplace(*frame.wake);
}

}  // namespace pathmark::preview
