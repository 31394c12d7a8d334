/// A user's existing Vitis project: hls_config.cfg and Tcl directives.
#ifndef HLSC_TOOL_PROJECT_FILE_H
#define HLSC_TOOL_PROJECT_FILE_H

#include <string>
#include <vector>

#include "frontend/placed_directive.h"

namespace hlsc {

/// What a project file says; paths are relative to the file's directory until read_config makes them whole.
struct ProjectFile {
  std::string top;
  std::vector<std::string> files, test_bench_files;  ///< Headers and data files left out of `files`.
  std::vector<std::string> include_dirs, defines;    ///< From syn.cflags.
  std::vector<std::string> test_bench_flags;         ///< tb.cflags, word by word.
  std::string standard;                              ///< From -std= in syn.cflags.
  std::string target;                                ///< From the part; empty when there is none.
  double period = 0;                                 ///< ns; 0: not given.
  std::vector<PlacedDirective> directives;
};

/// Reads a file of `key=value` lines. Throws CompileError at a line that makes no sense.
ProjectFile read_config(const std::string& path);

/// Reads the set_directive_* commands of a Tcl file; other commands are passed over.
std::vector<PlacedDirective> read_tcl_directives(const std::string& path);

bool is_source_file(const std::string& name);

/// One directive from its kind and words: a location `function/label`, a variable for the kinds that have
/// one, options as `key=value`, `-key value` or `-flag`.
PlacedDirective placed_directive(const std::string& kind, const std::vector<std::string>& words,
                                 const SourceLocation& where);

}  // namespace hlsc

#endif
