/// The hardware primitives as LLVM calls: what each does and how it is made. All take a predicate i1 as last
/// argument.
#ifndef HLSC_MIDDLE_PRIMITIVES_H
#define HLSC_MIDDLE_PRIMITIVES_H

#include "middle/llvm_headers.h"

namespace hlsc {

enum class Primitive {
  kNone,
  kRead,    ///< iW hls.read.iW(ptr stream, i1)
  kWrite,   ///< void hls.write.iW(ptr stream, iW, i1)
  kEmpty,   ///< i1 hls.empty(ptr stream, i1)
  kFull,    ///< i1 hls.full(ptr stream, i1)
  kLoad,    ///< iW hls.load.iW(ptr, i1)
  kStore,   ///< void hls.store.iW(ptr, iW, i1)
  kResult,  ///< void hls.result.iW(iW, i1): what the function returns, where it goes on with its next call
};

Primitive primitive_of(const llvm::CallInst& call);

/// Whether a read or write is made with `is_lock`.
bool is_lock(const llvm::CallInst& call);

/// `is_lock`: what accesses the object that holds the stream does not pass the read or write.
llvm::CallInst* create_read(llvm::IRBuilder<>& builder, llvm::Value* stream, unsigned width,
                            llvm::Value* predicate, bool is_lock = false);
llvm::CallInst* create_write(llvm::IRBuilder<>& builder, llvm::Value* stream, llvm::Value* data,
                             llvm::Value* predicate, bool is_lock = false);
/// hls.empty or hls.full.
llvm::CallInst* create_status(llvm::IRBuilder<>& builder, const char* name, llvm::Value* stream);
llvm::CallInst* create_load(llvm::IRBuilder<>& builder, llvm::Value* pointer, llvm::Type* type,
                            llvm::Value* predicate);
llvm::CallInst* create_store(llvm::IRBuilder<>& builder, llvm::Value* pointer, llvm::Value* data,
                             llvm::Value* predicate);
/// Of an integer, or a struct of integers, which stand in the result from the lowest bits on.
void create_result(llvm::IRBuilder<>& builder, llvm::Value& value);

/// The pointer that a load or store, plain or predicated, goes through; null for other instructions.
llvm::Value* accessed_pointer(llvm::Instruction& instruction);

/// Makes every plain load and store a primitive, which LLVM neither merges nor moves into phis of pointers.
void accesses_to_primitives(llvm::Function& function);

}  // namespace hlsc

#endif
