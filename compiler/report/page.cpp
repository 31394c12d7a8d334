#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "report/page_template.h"
#include "report/write.h"

namespace hlsc {
namespace {

constexpr const char* kDataMark = "/*REPORT*/";

/// Text of the source files that anything in the report names; one that cannot be read is left out.
nlohmann::ordered_json sources_of(const Report& report) {
  std::set<std::string> names;
  for (const ModuleReport& module : report.modules) {
    names.insert(module.location.file);
    for (const BlockReport& block : module.blocks)
      for (const ScheduledOperation& op : block.operations) names.insert(op.location.file);
  }
  nlohmann::ordered_json sources = nlohmann::ordered_json::object();
  for (const std::string& name : names) {
    std::ifstream in(name);
    std::stringstream text;
    if (in && text << in.rdbuf()) sources[name] = text.str();
  }
  return sources;
}

/// JSON inside a script element must not close it.
std::string escaped(std::string json) {
  for (size_t at = 0; (at = json.find("</", at)) != std::string::npos; at += 3) json.insert(at + 1, "\\");
  return json;
}

}  // namespace

std::string report_page(const Report& report) {
  auto data = nlohmann::ordered_json::parse(report_json(report));
  data["sources"] = sources_of(report);
  std::string page = kPageTemplate;
  std::string text = escaped(data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  return page.replace(page.find(kDataMark), std::string(kDataMark).size(), text);
}

}  // namespace hlsc
