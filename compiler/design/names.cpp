#include "design/names.h"

#include <cctype>
#include <set>

namespace hlsc {

namespace {

/// `_q` and `_s<stage>` are the endings of registers that the emitter derives from a name.
bool has_generated_suffix(const std::string& name) {
  size_t underscore = name.rfind('_');
  if (underscore == std::string::npos || underscore + 1 == name.size()) return false;
  std::string suffix = name.substr(underscore + 1);
  if (suffix == "q") return true;
  return suffix[0] == 's' && suffix.size() > 1 &&
         suffix.find_first_not_of("0123456789", 1) == std::string::npos;
}

const std::set<std::string>& keywords() {
  static const std::set<std::string> words = {
      "always",   "and",        "assign",   "automatic", "begin",     "buf",       "case",        "cell",
      "config",   "default",    "design",   "edge",      "else",      "end",       "event",       "for",
      "force",    "function",   "generate", "if",        "initial",   "inout",     "input",       "integer",
      "join",     "large",      "library",  "medium",    "module",    "nand",      "negedge",     "nor",
      "not",      "or",         "output",   "parameter", "posedge",   "pulldown",  "pullup",      "real",
      "reg",      "release",    "repeat",   "rnmos",     "scalared",  "signed",    "small",       "specify",
      "strong0",  "strong1",    "supply0",  "supply1",   "table",     "task",      "time",        "tran",
      "tri",      "unsigned",   "use",      "vectored",  "wait",      "wand",      "weak0",       "weak1",
      "while",    "wire",       "wor",      "xnor",      "xor",       "instance",  "fork",        "deassign",
      "disable",  "bit",        "byte",     "char",      "int",       "logic",     "string",      "do",
      "break",    "continue",   "return",   "class",     "new",       "this",      "priority",    "unique",
      "final",    "var",        "type",     "expect",    "property",  "sequence",  "cover",       "assert",
      "assume",   "before",     "bind",     "bins",      "clocking",  "const",     "constraint",  "context",
      "cross",    "dist",       "enum",     "export",    "extends",   "extern",    "first_match", "foreach",
      "global",   "iff",        "import",   "inside",    "interface", "intersect", "local",       "longint",
      "matches",  "modport",    "null",     "package",   "packed",    "program",   "protected",   "pure",
      "rand",     "randc",      "ref",      "shortint",  "solve",     "static",    "struct",      "super",
      "tagged",   "throughout", "timeunit", "typedef",   "union",     "virtual",   "void",        "with",
      "within",   "checker",    "let",      "restrict",  "strong",    "weak",      "until",       "implies",
      "accept_on"};
  return words;
}

}  // namespace

bool is_keyword(const std::string& word) { return keywords().count(word) > 0; }

NameTable::NameTable() {
  for (const std::string& word : keywords()) used_[word] = 1;
  for (const char* signal : {"clk", "rst", "state", "ap_clk", "ap_rst", "ap_rst_n", "ap_start", "ap_done",
                             "ap_idle", "ap_ready", "ap_continue"})
    used_[signal] = 1;
  // Members of the class that Verilator makes of a top, whose ports are members too.
  for (const char* member : {"eval", "eval_step", "eval_end_step", "trace", "name", "contextp", "rootp",
                             "vlSymsp", "threads", "hierName", "modelName"})
    used_[member] = 1;
}

std::string NameTable::unique(const std::string& wanted, const std::string& otherwise) {
  std::string name;
  for (char c : wanted) {
    bool keep = std::isalnum(static_cast<unsigned char>(c));
    if (keep)
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  if (name.empty()) name = otherwise;
  if (has_generated_suffix(name)) name += "v";
  if (std::isdigit(static_cast<unsigned char>(name[0]))) name = "v" + name;
  int& count = used_[name];
  if (count++ == 0) return name;
  while (true) {
    std::string numbered = name + "_" + std::to_string(count);
    if (used_.emplace(numbered, 1).second) return numbered;
    ++count;
  }
}

std::string variable_part(const std::string& llvm_name) {
  std::string name = llvm_name.substr(0, llvm_name.find('.'));
  while (!name.empty() && std::isdigit(static_cast<unsigned char>(name.back()))) name.pop_back();
  return name;
}

}  // namespace hlsc
