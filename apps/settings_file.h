/// settings.yaml: what a user chooses, as a file. docs/command.md lists every key.
#ifndef FLOORLINE_APPS_SETTINGS_FILE_H
#define FLOORLINE_APPS_SETTINGS_FILE_H

#include <filesystem>
#include <vector>

#include "host/parameters.h"
#include "report/document.h"

namespace floorline::app {

/// Overwrites in `settings` what the file names. Throws Error with one sentence for an unknown key, a value
/// of the wrong kind or out of range.
void read_settings(const std::filesystem::path& file, Settings& settings);

/// Every key with its value and meaning, for the report and for docs.
std::vector<report::Parameter> describe(const Settings& settings);

}  // namespace floorline::app

#endif
