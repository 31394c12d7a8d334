/// Fills a report from a sequence: both models in step, scores, grid.
#ifndef FLOORLINE_APPS_SEQUENCE_REPORT_H
#define FLOORLINE_APPS_SEQUENCE_REPORT_H

#include "drive.h"
#include "report/document.h"

namespace floorline::app {

struct ReportRequest {
  std::string sequence;
  Settings settings;
  PoseSource poses;
  int frames;  ///< At most so many frames in the slider; the figures come from all.
};

/// Throws Error like Drive and score().
report::Document make_document(const ReportRequest& request);

}  // namespace floorline::app

#endif
