/// C++ and C sources to LLVM IR, with what only Clang's syntax tree knows: type layouts and parameter names.
#ifndef HLSC_FRONTEND_FRONTEND_H
#define HLSC_FRONTEND_FRONTEND_H

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "frontend/diagnostic.h"
#include "frontend/placed_directive.h"
#include "frontend/type_layout.h"

namespace llvm {
class LLVMContext;
class Module;
}  // namespace llvm

namespace hlsc {

struct FrontendOptions {
  std::vector<std::string> files;
  std::vector<std::string> include_dirs;
  std::vector<std::string> defines;
  std::string standard;                     ///< As -std=; empty: c++17 for C++, c17 for C.
  std::string top;                          ///< Name of the top function, as written or qualified.
  std::vector<PlacedDirective> directives;  ///< From project files; those of the sources stand there.
  bool is_simulation = false;  ///< Parse what C simulation with finite FIFOs runs: no __SYNTHESIS__.
};

/// A stream that a parameter is or holds.
struct StreamMember {
  std::string suffix;        ///< Of its name: empty, `_left` for a member, `_2` for an array element.
  uint64_t byte_offset = 0;  ///< Of the handle in the parameter's object.
  int index = -1;            ///< In an array of streams.
  TypeLayout layout;         ///< Of the stream's elements.
};

/// A parameter as the programmer declared it.
struct Parameter {
  std::string name;
  std::string type_text;  ///< The type as C++ text, all names qualified; `%` stands for the declared name.
  TypeLayout layout;      ///< Of the value, the referenced value, or one array element.
  std::vector<uint64_t> dims;         ///< Array dimensions; a leading 0 stands for a plain pointer.
  std::vector<StreamMember> streams;  ///< Not empty: the parameter is, or holds, streams.
  TypeLayout members;                 ///< Of one struct that holds streams: what else it holds.
  bool is_indirect = false;           ///< Reference or pointer.
  bool is_const = false;              ///< The function cannot write to it.
};

/// A function as the programmer declared it.
struct FunctionInfo {
  std::string name;       ///< Without namespace and template arguments.
  std::string qualified;  ///< With both.
  SourceLocation location;
  std::vector<Parameter> parameters;
  TypeLayout result;          ///< No leaves: void.
  std::string result_text;    ///< The result's type as C++ text.
  bool is_c = false;          ///< C linkage.
  bool is_in_c_file = false;  ///< Written in C.
};

struct Program {
  Program();
  ~Program();
  Program(Program&&) noexcept;

  std::unique_ptr<llvm::LLVMContext> context;
  std::unique_ptr<llvm::Module> module;
  std::string top;          ///< Mangled name of the top function.
  std::string top_problem;  ///< Why the top's parameters have no hardware form; empty when they have.
  /// Layout of T by the mangled name of each stream primitive instance `__hls_stream_read<T>` and its like.
  std::map<std::string, TypeLayout> stream_types;
  std::map<std::string, FunctionInfo> functions;  ///< By mangled name; those defined in the user's sources.

  /// The label of the loop at this place; empty: it has none.
  std::string loop_label(const SourceLocation& loop) const;
  void set_loop_label(const SourceLocation& loop, const std::string& label);

 private:
  std::map<std::string, std::string> loop_labels_;
};

/// Parses all files and links them to one module of unoptimised IR. Throws CompileError with Clang's messages
/// or our own.
Program parse_program(const FrontendOptions& options);

}  // namespace hlsc

#endif
