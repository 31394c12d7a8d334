#include "frontend/frontend.h"

#include <clang/AST/ASTConsumer.h>
#include <clang/AST/Mangle.h>
#include <clang/AST/RecordLayout.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/CodeGen/CodeGenAction.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/MultiplexConsumer.h>
#include <clang/Frontend/TextDiagnosticPrinter.h>
#include <clang/Frontend/Utils.h>
#include <clang/Lex/PreprocessorOptions.h>
#include <clang/Sema/Sema.h>
#include <clang/Sema/SemaConsumer.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>
#include <llvm/Linker/Linker.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/Path.h>

#include <algorithm>

#include "frontend/constant_calls.h"
#include "frontend/directive_insertion.h"
#include "frontend/language_checks.h"
#include "frontend/pragma_handler.h"

namespace hlsc {
namespace {

/// A file by its whole path: Clang names it as it was given, debug information from the folder of the
/// compile.
std::string key_of(SourceLocation place) {
  llvm::SmallString<256> path(place.file);
  (void)llvm::sys::fs::make_absolute(path);
  llvm::sys::path::remove_dots(path, /*remove_dot_dot=*/true);
  place.file = path.str();
  return place.text();
}

}  // namespace

Program::Program() = default;
Program::~Program() {
  module.reset();  // Before its context.
}
Program::Program(Program&&) noexcept = default;

std::string Program::loop_label(const SourceLocation& loop) const {
  auto found = loop_labels_.find(key_of(loop));
  return found == loop_labels_.end() ? "" : found->second;
}

void Program::set_loop_label(const SourceLocation& loop, const std::string& label) {
  loop_labels_[key_of(loop)] = label;
}

namespace {

std::string mangled_name(clang::MangleContext& mangler, const clang::FunctionDecl* function) {
  if (!mangler.shouldMangleDeclName(function)) return function->getNameAsString();
  std::string text;
  llvm::raw_string_ostream out(text);
  mangler.mangleName(clang::GlobalDecl(function), out);
  return text;
}

bool is_stream_type(clang::QualType type) {
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  return record && record->getQualifiedNameAsString() == "hls::stream";
}

/// `type` as text that declares `name`, with qualified names.
std::string type_text(clang::ASTContext& context, clang::QualType type, const std::string& name) {
  clang::PrintingPolicy policy(context.getLangOpts());
  policy.SuppressTagKeyword = context.getLangOpts().CPlusPlus;
  policy.Bool = true;
  std::string text = name;
  type.getCanonicalType().getAsStringInternal(text, policy);
  return text;
}

/// hls::stream<T> or hls::stream<T, DEPTH>, which derives from it: T.
clang::QualType stream_element(clang::QualType type) {
  const auto* stream = llvm::cast<clang::ClassTemplateSpecializationDecl>(type->getAsCXXRecordDecl());
  return stream->getTemplateArgs()[0].getAsType();
}

/// Adds the streams of `type` (an array of it when `dims` are left) at `place`.
void collect_streams(clang::ASTContext& context, clang::QualType type, llvm::ArrayRef<uint64_t> dims,
                     const StreamMember& place, std::vector<StreamMember>& streams) {
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  if (!record || !record->hasDefinition()) return;
  uint64_t bytes = context.getTypeSizeInChars(type).getQuantity();
  if (!dims.empty()) {
    uint64_t stride = bytes;
    for (uint64_t size : dims.drop_front()) stride *= size;
    for (uint64_t i = 0; i < dims[0]; ++i) {
      StreamMember element = place;
      element.suffix += "_" + std::to_string(i);
      element.byte_offset += i * stride;
      element.index = i;
      collect_streams(context, type, dims.drop_front(), element, streams);
    }
  } else if (is_stream_type(type)) {
    streams.push_back(place);
    streams.back().layout = layout_of(context, stream_element(type));
  } else {
    for (const clang::CXXBaseSpecifier& base : record->bases()) {
      StreamMember part = place;
      part.byte_offset += context.getASTRecordLayout(record)
                              .getBaseClassOffset(base.getType()->getAsCXXRecordDecl())
                              .getQuantity();
      collect_streams(context, base.getType(), {}, part, streams);
    }
    for (const clang::FieldDecl* field : record->fields()) {
      StreamMember member = place;
      member.suffix += "_" + field->getNameAsString();
      member.byte_offset += context.getFieldOffset(field) / 8;
      std::vector<uint64_t> field_dims;
      clang::QualType field_type = field->getType();
      while (const clang::ConstantArrayType* array = context.getAsConstantArrayType(field_type)) {
        field_dims.push_back(array->getSize().getZExtValue());
        field_type = array->getElementType();
      }
      collect_streams(context, field_type, field_dims, member, streams);
    }
  }
}

/// What a struct holds beside its streams.
TypeLayout members_beside(clang::ASTContext& context, clang::QualType type,
                          const std::vector<StreamMember>& streams) {
  TypeLayout layout = layout_of(context, type);
  std::erase_if(layout.leaves, [&](const Leaf& leaf) {
    return std::ranges::any_of(
        streams, [&](const StreamMember& stream) { return stream.byte_offset == leaf.byte_offset; });
  });
  return layout;
}

/// The part of a parameter that its type tells; layout errors surface only where the parameter is used. In
/// C simulation streams are objects of the library, of which the layout says nothing.
Parameter describe(clang::ASTContext& context, const clang::ParmVarDecl* declaration, bool is_simulation) {
  Parameter parameter;
  parameter.name = declaration->getNameAsString();
  parameter.type_text = type_text(context, declaration->getType(), "%");
  clang::QualType type = declaration->getOriginalType().getNonReferenceType();
  parameter.is_indirect =
      declaration->getType()->isReferenceType() || declaration->getType()->isPointerType();
  bool top_level = true;
  while (true) {
    if (const clang::ConstantArrayType* array = context.getAsConstantArrayType(type)) {
      parameter.dims.push_back(array->getSize().getZExtValue());
      type = array->getElementType();
    } else if (const clang::ArrayType* open_array = context.getAsArrayType(type)) {
      parameter.dims.push_back(0);
      type = open_array->getElementType();
    } else if (top_level && type->isPointerType()) {
      parameter.dims.push_back(0);
      type = type->getPointeeType();
    } else {
      break;
    }
    top_level = false;
  }
  if (declaration->getType()->isPointerType() && is_stream_type(declaration->getType()->getPointeeType()) &&
      declaration->getOriginalType()->isPointerType())
    parameter.dims.clear();  // One stream, by its address.
  parameter.is_const = type.isConstQualified() || !parameter.is_indirect;
  collect_streams(context, type, parameter.dims, {}, parameter.streams);
  if (parameter.streams.empty()) {
    parameter.layout = layout_of(context, type);
  } else {
    parameter.layout = parameter.streams[0].layout;
    if (parameter.dims.empty() && !is_simulation)
      parameter.members = members_beside(context, type, parameter.streams);
  }
  return parameter;
}

/// Collects stream element types and the user's functions from one translation unit.
class ProgramReader : public clang::SemaConsumer, public clang::RecursiveASTVisitor<ProgramReader> {
 public:
  ProgramReader(Program& program, const FrontendOptions& options, std::vector<std::string>& tops)
      : program_(program), options_(options), tops_(tops) {}

  bool shouldVisitTemplateInstantiations() const { return true; }

  void Initialize(clang::ASTContext& context) override { context_ = &context; }
  void InitializeSema(clang::Sema& sema) override { sema_ = &sema; }
  void ForgetSema() override { sema_ = nullptr; }
  bool HandleTopLevelDecl(clang::DeclGroupRef declarations) override {
    if (!context_->getDiagnostics().hasErrorOccurred()) fold_constant_calls(*context_, declarations);
    return true;
  }

  void HandleTranslationUnit(clang::ASTContext& context) override {
    if (context.getDiagnostics().hasErrorOccurred()) return;
    mangler_.reset(context.createMangleContext());
    TraverseDecl(context.getTranslationUnitDecl());
    if (!options_.is_simulation) check_language(context);
  }

  bool VisitFunctionDecl(clang::FunctionDecl* function) {
    if (function->isDependentContext()) return true;
    llvm::StringRef name = function->getIdentifier() ? function->getName() : "";
    if (name.starts_with("__hls_stream_") && function->getTemplateSpecializationArgs())
      program_.stream_types[mangled_name(*mangler_, function)] =
          layout_of(*context_, function->getTemplateSpecializationArgs()->get(0).getAsType());
    else if (function->isThisDeclarationADefinition() && !llvm::isa<clang::CXXMethodDecl>(function) &&
             may_be_process(function))
      read_function(function);
    return true;
  }

  bool VisitLabelStmt(clang::LabelStmt* labelled) {
    const clang::Stmt* loop = labelled->getSubStmt();
    if (llvm::isa<clang::ForStmt, clang::WhileStmt, clang::DoStmt, clang::CXXForRangeStmt>(loop))
      program_.set_loop_label(place_of(loop->getBeginLoc()), labelled->getName());
    return true;
  }

 private:
  SourceLocation place_of(clang::SourceLocation location) const {
    clang::PresumedLoc place = context_->getSourceManager().getPresumedLoc(location);
    return {place.getFilename(), place.getLine(), place.getColumn()};
  }

  /// Functions of the user, and those behind hls::split and hls::merge (hls_np_channel.h).
  bool may_be_process(const clang::FunctionDecl* function) const {
    return !context_->getSourceManager().isInSystemHeader(function->getLocation()) ||
           llvm::StringRef(function->getQualifiedNameAsString()).starts_with("hls::np_detail::");
  }

  void read_function(clang::FunctionDecl* function) {
    FunctionInfo info;
    info.name = function->getNameAsString();
    info.qualified = function->getQualifiedNameAsString();
    info.location = place_of(function->getLocation());
    info.result_text = type_text(*context_, function->getReturnType(), "");
    info.is_c = function->isExternC();
    info.is_in_c_file = !function->getASTContext().getLangOpts().CPlusPlus;
    std::string mangled = mangled_name(*mangler_, function);
    bool is_top = info.name == options_.top || info.qualified == options_.top;
    if (is_top) tops_.push_back(mangled);
    clang::SourceLocation where = function->getLocation();
    try {
      for (const clang::ParmVarDecl* parameter : function->parameters()) {
        where = parameter->getLocation();
        instantiate(*parameter);
        info.parameters.push_back(describe(*context_, parameter, options_.is_simulation));
      }
      where = function->getLocation();
      if (!function->getReturnType()->isVoidType())
        info.result = layout_of(*context_, function->getReturnType());
    } catch (const CompileError& problem) {
      // Of no matter in a helper that takes, say, a pointer to pointer: it is inlined.
      if (is_top) program_.top_problem = located(where, problem);
      return;
    }
    program_.functions[mangled] = info;
  }

  /// The problem's text, at `where` when it has no place of its own.
  std::string located(clang::SourceLocation where, const CompileError& problem) const {
    std::string text = problem.what();
    if (text.rfind("error: ", 0) != 0 || where.isInvalid()) return text;
    return place_of(where).text() + ": " + text;
  }

  /// A class template that only an unused array or pointer names, as ap_int<16> in `ap_int<16> x[8]`, has no
  /// layout yet.
  void instantiate(const clang::ParmVarDecl& parameter) {
    clang::QualType type = parameter.getOriginalType().getNonReferenceType();
    if (type->isPointerType()) type = type->getPointeeType();
    type = context_->getBaseElementType(type);
    if (type->isRecordType()) (void)sema_->isCompleteType(parameter.getLocation(), type);
  }

  Program& program_;
  const FrontendOptions& options_;
  std::vector<std::string>& tops_;
  clang::ASTContext* context_ = nullptr;
  clang::Sema* sema_ = nullptr;
  std::unique_ptr<clang::MangleContext> mangler_;
};

class ParseAction : public clang::EmitLLVMOnlyAction {
 public:
  ParseAction(Program& program, const FrontendOptions& options, std::vector<std::string>& tops)
      : EmitLLVMOnlyAction(program.context.get()), program_(program), options_(options), tops_(tops) {}

 protected:
  bool BeginSourceFileAction(clang::CompilerInstance& compiler) override {
    add_pragma_handler(compiler.getPreprocessor());
    return EmitLLVMOnlyAction::BeginSourceFileAction(compiler);
  }
  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance& compiler,
                                                        llvm::StringRef file) override {
    std::vector<std::unique_ptr<clang::ASTConsumer>> consumers;
    consumers.push_back(std::make_unique<ProgramReader>(program_, options_, tops_));
    consumers.push_back(EmitLLVMOnlyAction::CreateASTConsumer(compiler, file));
    return std::make_unique<clang::MultiplexConsumer>(std::move(consumers));
  }

 private:
  Program& program_;
  const FrontendOptions& options_;
  std::vector<std::string>& tops_;
};

std::vector<std::string> clang_arguments(const FrontendOptions& options, const std::string& file) {
  bool is_c = llvm::sys::path::extension(file) == ".c";
  std::string compiler = HLSC_CLANG;
  if (is_c) compiler.resize(compiler.rfind("++"));
  std::vector<std::string> arguments = {compiler};
  arguments.push_back("-std=" + (options.standard.empty() ? (is_c ? "c17" : "c++17") : options.standard));
  for (const char* fixed :
       {"-c", "-O2", "-g", "-gcolumn-info", "-fno-threadsafe-statics", "-fno-discard-value-names",
        "-fno-vectorize", "-Wno-unknown-pragmas", "-Wno-unused-value", "-Wno-everything",
        "-Werror=return-type", "-fwrapv", "-fno-math-errno"})
    arguments.push_back(fixed);
  if (!options.is_simulation)
    for (const char* fixed : {"-fno-exceptions", "-fno-rtti", "-D__SYNTHESIS__", "-D__FLOORLINE_HLSC__"})
      arguments.push_back(fixed);
  for (const std::string& define : options.defines) arguments.push_back("-D" + define);
  arguments.push_back(options.is_simulation ? "-isystem" HLSC_COSIM_DIR "/finite"
                                            : "-isystem" HLSC_INCLUDE_DIR);
  arguments.push_back("-isystem" HLSC_TYPES_DIR);
  for (const std::string& dir : options.include_dirs) arguments.push_back("-I" + dir);
  arguments.push_back(file);
  return arguments;
}

/// Parses without generating code, to find where directives go.
class PlacementAction : public clang::ASTFrontendAction {
 public:
  PlacementAction(const std::vector<PlacedDirective>& directives, std::set<size_t>& found)
      : directives_(directives), found_(found) {}
  Insertions insertions;

 protected:
  bool BeginSourceFileAction(clang::CompilerInstance& compiler) override {
    add_pragma_handler(compiler.getPreprocessor());
    return true;
  }
  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance&, llvm::StringRef) override {
    return std::make_unique<Consumer>(*this);
  }

 private:
  struct Consumer : clang::ASTConsumer {
    explicit Consumer(PlacementAction& owner) : action(owner) {}
    void HandleTranslationUnit(clang::ASTContext& context) override {
      action.insertions = find_insertions(context, action.directives_, action.found_);
    }
    PlacementAction& action;
  };
  const std::vector<PlacedDirective>& directives_;
  std::set<size_t>& found_;
};

/// Runs `action` on one file, with `insertions` made. Throws CompileError with Clang's messages.
void run_clang(const FrontendOptions& options, const std::string& file, const Insertions& insertions,
               clang::FrontendAction& action) {
  std::vector<std::string> arguments = clang_arguments(options, file);
  std::vector<const char*> pointers;
  for (const std::string& argument : arguments) pointers.push_back(argument.c_str());

  std::string messages;
  llvm::raw_string_ostream message_stream(messages);
  auto printer_options = llvm::makeIntrusiveRefCnt<clang::DiagnosticOptions>();
  auto* printer = new clang::TextDiagnosticPrinter(message_stream, printer_options.get());
  auto diagnostics = clang::CompilerInstance::createDiagnostics(printer_options.get(), printer);

  clang::CreateInvocationOptions invocation_options;
  invocation_options.Diags = diagnostics;
  std::shared_ptr<clang::CompilerInvocation> invocation =
      clang::createInvocation(pointers, invocation_options);
  if (!invocation) throw CompileError(messages.empty() ? "cannot start Clang for " + file : messages);
  clang::PreprocessorOptions& preprocessor = invocation->getPreprocessorOpts();
  preprocessor.addRemappedFile("/hlsc_prelude.h",
                               llvm::MemoryBuffer::getMemBufferCopy(kPragmaPrelude).release());
  preprocessor.Includes.push_back("/hlsc_prelude.h");
  for (const auto& [name, texts] : insertions) {
    auto source = llvm::MemoryBuffer::getFile(name);
    if (!source) throw CompileError("cannot read " + name + "; check its name");
    preprocessor.addRemappedFile(
        name, llvm::MemoryBuffer::getMemBufferCopy(inserted((*source)->getBuffer().str(), texts)).release());
  }
  invocation->getCodeGenOpts().DisableLLVMPasses = true;
  invocation->getFrontendOpts().DisableFree = false;

  clang::CompilerInstance compiler;
  compiler.setInvocation(invocation);
  compiler.setDiagnostics(diagnostics.get());
  bool done = compiler.ExecuteAction(action);
  if (!done || diagnostics->hasErrorOccurred())
    throw CompileError(messages.empty() ? "cannot compile " + file : messages);
}

void parse_file(Program& program, const FrontendOptions& options, const std::string& file,
                std::set<size_t>& found, std::vector<std::string>& tops) {
  Insertions insertions;
  if (!options.directives.empty()) {
    PlacementAction placement(options.directives, found);
    run_clang(options, file, {}, placement);
    insertions = placement.insertions;
  }
  ParseAction action(program, options, tops);
  run_clang(options, file, insertions, action);
  std::unique_ptr<llvm::Module> module = action.takeModule();
  if (!program.module)
    program.module = std::move(module);
  else if (llvm::Linker::linkModules(*program.module, std::move(module)))
    throw CompileError("cannot link " + file + ": give every function one definition");
}

void check_found(const std::vector<PlacedDirective>& directives, const std::set<size_t>& found) {
  for (size_t i = 0; i < directives.size(); ++i) {
    if (found.count(i)) continue;
    const PlacedDirective& lost = directives[i];
    throw CompileError(
        lost.location,
        "the sources have no " + (lost.label.empty() ? "function" : "loop '" + lost.label + "' in") + " '" +
            lost.function + "'" + (lost.variable.empty() ? "" : " with a variable '" + lost.variable + "'") +
            "; correct the directive");
  }
}

}  // namespace

Program parse_program(const FrontendOptions& options) {
  Program program;
  program.context = std::make_unique<llvm::LLVMContext>();
  std::vector<std::string> tops;
  std::set<size_t> found;
  for (const std::string& file : options.files) parse_file(program, options, file, found, tops);
  check_found(options.directives, found);
  std::sort(tops.begin(), tops.end());
  tops.erase(std::unique(tops.begin(), tops.end()), tops.end());
  if (tops.empty())
    throw CompileError("no function '" + options.top +
                       "' is defined in the sources; give its name with --top");
  if (tops.size() > 1)
    throw CompileError("function '" + options.top +
                       "' has several overloads or instances; give the top a name of its own");
  program.top = tops[0];
  if (options.is_simulation) return program;
  // Without native integer sizes LLVM narrows operations to the width that is needed, as hardware wants.
  program.module->setDataLayout("e-m:e-p270:32:32-p271:32:32-p272:64:64-i64:64-i128:128-f80:128-S128");
  return program;
}

}  // namespace hlsc
