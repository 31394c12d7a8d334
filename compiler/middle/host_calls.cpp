#include "middle/host_calls.h"

#include "middle/llvm_headers.h"
#include "middle/source_location.h"

namespace hlsc {
namespace {

using namespace llvm;

/// Failing assertions, and what <iostream> and destructors of static objects do around main().
bool is_silent(StringRef name) {
  return name == "__assert_fail" || name == "__assert" || name == "__cxa_atexit" ||
         name.starts_with("_ZNSt8ios_base4Init");
}

/// What to call the printing function in a message; empty for other functions.
std::string printing_name(StringRef name) {
  static const std::set<std::string> kC = {"printf",  "fprintf", "puts",  "fputs",
                                           "putchar", "perror",  "fflush"};
  if (kC.count(name.str())) return name.str();
  for (const char* prefix : {"_ZNSo", "_ZStls", "_ZSt4endl", "_ZSt5flush"})
    if (name.starts_with(prefix)) return "std::ostream";
  return "";
}

}  // namespace

void remove_host_calls(Module& module, Diagnostics& diagnostics) {
  std::set<std::pair<std::string, unsigned>> told;  // One warning a line: each << is a call.
  for (Function& function : module)
    for (Instruction& instruction : make_early_inc_range(instructions(function))) {
      auto* call = dyn_cast<CallInst>(&instruction);
      Function* callee = call ? call->getCalledFunction() : nullptr;
      if (!callee) continue;
      std::string printing = printing_name(callee->getName());
      SourceLocation where = location_of(*call);
      bool is_news =
          !printing.empty() && !is_library_file(where.file) && told.insert({where.file, where.line}).second;
      if (is_news)
        diagnostics.warn(where, "'" + printing +
                                    "' is left out of the hardware; put it between "
                                    "#ifndef __SYNTHESIS__ and #endif");
      if (printing.empty() && !is_silent(callee->getName())) continue;
      if (!call->use_empty())  // The stream that was printed to, or the number of characters.
        call->replaceAllUsesWith(call->getType()->isPointerTy() ? call->getArgOperand(0)
                                                                : Constant::getNullValue(call->getType()));
      call->eraseFromParent();
    }
}

}  // namespace hlsc
