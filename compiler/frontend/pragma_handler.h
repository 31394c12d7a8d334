/// Turns `#pragma HLS ...` into a call that travels through Clang's code generation to LLVM IR.
#ifndef HLSC_FRONTEND_PRAGMA_HANDLER_H
#define HLSC_FRONTEND_PRAGMA_HANDLER_H

namespace clang {
class Preprocessor;
}

namespace hlsc {

/// Declaration of the marker; the frontend puts it before the user's source.
///
/// `#pragma HLS KIND a=1 variable=v` becomes `__hls_pragma("KIND a=1", "v", &(v));`. An option whose value is
/// a name (a macro is expanded before) becomes `key=$n` with the expression's value as a further argument, so
/// that template parameters and constants work as values.
extern const char* const kPragmaPrelude;

/// Name of the marker function in LLVM IR.
extern const char* const kPragmaMarker;

void add_pragma_handler(clang::Preprocessor& preprocessor);

}  // namespace hlsc

#endif
