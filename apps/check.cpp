#include "check.h"

#include <algorithm>

#include "agreement.h"
#include "natural_units.h"
#include "progress.h"

namespace floorline::app {
namespace {

std::vector<golden::Contact> contacts_of(const Finding& finding) {
  std::vector<golden::Contact> contacts;
  for (const golden::FloorPoint& point : finding.points) contacts.push_back(point.contact);
  return contacts;
}

}  // namespace

bool CheckResult::ok() const {
  return std::all_of(figures.begin(), figures.end(),
                     [](const report::Figure& figure) { return figure.ok(); });
}

CheckResult check(Drive& drive, const std::function<void(const CheckedFrame&)>& look) {
  const std::unique_ptr<Model> golden = golden_model(drive);
  CSimulation simulation(drive.sequence().camera().size);
  StageCheck stage_check(drive.configuration().ring_rows());
  Agreement agreement;
  Progress progress("check");
  for (int i = 0; i < drive.frame_count(); ++i) {
    const DriveFrame frame = drive.next();
    StageCapture capture;
    const FrameOutput output =
        simulation.run(frame.image, frame.kernel, drive.configuration().lines(), &capture);
    const StagePairs stages = stage_check.add(frame.image, frame.golden, capture, output);
    const Finding kernel{in_natural_units(output.points), in_natural_units(output.obstacles)};
    const Finding twin = golden->run(frame);
    agreement.add(contacts_of(twin), contacts_of(kernel));
    look({frame, stages, kernel, twin, golden::high_threshold(frame.golden.threshold, capture.otsu_threshold),
          output.null_pixels});
    progress.advance(i + 1, drive.frame_count());
  }
  CheckResult result{stage_check.figures(), agreement.distances(), agreement.contacts()};
  result.figures.push_back({.name = "contacts_within_1px",
                            .label = "whole pipeline: contact points within 1 px",
                            .value = agreement.share_within_1px(),
                            .relation = report::Relation::at_least,
                            .bound = 0.99,
                            .unit = ""});
  return result;
}

}  // namespace floorline::app
