/// Hardware sections: what the other parts of the project add to a report as JSON files (schema:
/// docs/report.md).
#ifndef FLOORLINE_APPS_REPORT_HARDWARE_H
#define FLOORLINE_APPS_REPORT_HARDWARE_H

#include <filesystem>
#include <nlohmann/json.hpp>

namespace floorline::report {

/// Reads and checks one file; pictures are read from beside it and returned as data URIs. Returns the list of
/// sections. Throws std::runtime_error with one sentence that names the file, the section and what is
/// missing.
nlohmann::json read_hardware(const std::filesystem::path& file);

}  // namespace floorline::report

#endif
