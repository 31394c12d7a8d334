/// A report as text for a terminal, as JSON for programs, and as a page with the schedule viewer.
#ifndef HLSC_REPORT_WRITE_H
#define HLSC_REPORT_WRITE_H

#include <string>

#include "report/report.h"

namespace hlsc {

std::string report_text(const Report& report);
std::string report_json(const Report& report);

/// One HTML file without links to others. The source lines that the operations name are in it.
std::string report_page(const Report& report);

}  // namespace hlsc

#endif
