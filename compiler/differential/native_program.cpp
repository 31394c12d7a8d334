#include "differential/native_program.h"

#include <fmt/format.h>

#include <filesystem>

namespace hlsc::differential {
namespace {

std::string leaf_text(const Leaf& leaf) {
  return fmt::format("{{{}, {}, {}, {}}}", leaf.byte_offset, leaf.bytes, leaf.width, leaf.is_signed);
}

class NativeProgram {
 public:
  NativeProgram(const CompileResult& compiled, const CompileOptions& options, const Steering& steering)
      : compiled_(compiled),
        top_(compiled.top),
        ports_(compiled.interface),
        options_(options),
        steering_(steering) {}

  std::string text(std::uint64_t seed) {
    for (std::size_t i = 0; i < top_.parameters.size(); ++i) parameter(i);
    for (std::size_t i = 0; i < ports_.streams.size(); ++i) stream(i);
    for (std::size_t i = 0; i < ports_.memories.size(); ++i) memory(i);
    for (std::size_t i = 0; i < ports_.scalars.size(); ++i) scalar(i);
    std::string includes;
    for (const std::string& file : options_.frontend.files)
      includes += fmt::format("#include \"{}\"\n", std::filesystem::absolute(file).string());
    std::string result = top_.result.leaves.empty() ? "" : "auto result = ";
    std::string call = fmt::format("    {}{}({});\n", result, top_.qualified, arguments_);
    return includes + "\nint main() {\n" + fmt::format("  recorder::generator.seed({});\n", seed) +
           declarations_ + fmt::format("  for (int call = 0; call < {}; ++call) {{\n", steering_.calls) +
           before_ + call + after_ + "  }\n" + end_ + "  return 0;\n}\n";
  }

 private:
  std::string range_text(const std::string& name) const {
    auto found = steering_.ranges.find(name);
    if (found == steering_.ranges.end()) return "{false, 0, 0}";
    return fmt::format("{{true, {}, {}}}", found->second.low, found->second.high);
  }

  void parameter(std::size_t i) {
    const Parameter& parameter = top_.parameters[i];
    std::string leaves;
    for (const Leaf& leaf : parameter.layout.leaves) leaves += (leaves.empty() ? "" : ", ") + leaf_text(leaf);
    declarations_ += fmt::format("  const std::vector<recorder::Leaf> leaves_{} = {{{}}};\n", i, leaves);
    declarations_ += fmt::format("  static recorder::Object<decltype({}), {}> object_{}[{}]{{}};\n",
                                 top_.qualified, i, i, element_count_outer(i));
    bool is_array = !parameter.dims.empty();
    arguments_ += fmt::format("{}{}object_{}{}", i ? ", " : "", "", i, is_array ? "" : "[0]");
    if (parameter.streams.empty())
      before_ += fmt::format("    recorder::fill(object_{0}, {1}, {2}, leaves_{0}, {3});\n", i,
                             element_count(compiled_, steering_, i), parameter.layout.bytes,
                             range_text(parameter.name));
  }

  /// Objects of the parameter's pointee type: of a two-dimensional array its rows.
  long element_count_outer(std::size_t i) const {
    long count = element_count(compiled_, steering_, i);
    for (std::size_t d = 1; d < top_.parameters[i].dims.size(); ++d)
      count /= static_cast<long>(top_.parameters[i].dims[d]);
    return count;
  }

  void declare_words(const std::string& name) {
    declarations_ += fmt::format("  recorder::Words {}(\"{}\");\n", name, name);
  }

  void stream(std::size_t i) {
    const InterfaceStream& stream = ports_.streams[i];
    std::string words = fmt::format("stream_{}_hex", i), ends = fmt::format("stream_{}_end", i);
    std::string object = fmt::format("object_{}[{}]", stream.argument, stream.index < 0 ? 0 : stream.index);
    declare_words(words);
    declare_words(ends);
    std::string record = fmt::format("{}.object(&token, leaves_{}); ", words, stream.argument);
    if (stream.is_input)
      before_ += fmt::format(
          "    for (int i = 0; i < {0}; ++i) {{ decltype({1}.read()) token{{}}; recorder::fill(&token, 1, "
          "sizeof token, "
          "leaves_{2}, {3}); {4}{1}.write(token); }}\n",
          steering_.tokens, object, stream.argument, range_text(top_.parameters[stream.argument].name),
          record);
    else
      after_ += fmt::format("    while (!{0}.empty()) {{ auto token = {0}.read(); {1}}}\n", object, record);
    after_ += fmt::format("    {}.number({}.count());\n", ends, words);
    // What is left belongs to no call; the streams need not be empty at the end.
    if (stream.is_input) end_ += fmt::format("  while (!{0}.empty()) {0}.read();\n", object);
  }

  void memory(std::size_t i) {
    const InterfaceMemory& memory = ports_.memories[i];
    std::string leaves;
    for (const Leaf& leaf : memory.leaves) leaves += (leaves.empty() ? "" : ", ") + leaf_text(leaf);
    for (const char* moment : {"before", "after"}) {
      std::string words = fmt::format("memory_{}_{}", i, moment);
      declare_words(words);
      std::string record = fmt::format(
          "    for (long i = 0; i < {}; ++i) {}.object(reinterpret_cast<const char*>(object_{}) + i * {}, "
          "{{{}}});\n",
          element_count(compiled_, steering_, memory.argument), words, memory.argument, memory.stride,
          leaves);
      (std::string(moment) == "before" ? before_ : after_) += record;
    }
  }

  void scalar(std::size_t i) {
    const ScalarPort& port = ports_.scalars[i];
    std::string words = fmt::format("scalar_{}_hex", i);
    declare_words(words);
    std::string object = port.is_result ? "&result" : fmt::format("object_{}", port.argument);
    std::string raw = fmt::format(".object({}, {{{{{}, {}, {}, false}}}});\n", object, port.byte_offset,
                                  (port.width + 7) / 8, port.width);
    (port.is_output ? after_ : before_) += "    " + words + raw;
    if (!port.is_output || port.is_result) return;
    std::string old = fmt::format("scalar_{}_before", i);
    declare_words(old);
    before_ += "    " + old + raw;
  }

  const CompileResult& compiled_;
  const FunctionInfo& top_;
  const TopInterface& ports_;
  const CompileOptions& options_;
  const Steering& steering_;
  std::string declarations_, arguments_, before_, after_, end_;
};

}  // namespace

long element_count(const CompileResult& compiled, const Steering& steering, std::size_t index) {
  const Parameter& parameter = compiled.top.parameters[index];
  auto given = steering.elements.find(parameter.name);
  long count = 1;
  for (std::size_t d = 0; d < parameter.dims.size(); ++d) {
    bool is_open = parameter.dims[d] == 0;
    count *= !is_open                           ? static_cast<long>(parameter.dims[d])
             : given == steering.elements.end() ? 1
                                                : given->second;
  }
  return count;
}

std::string value_mask(const CompileResult& compiled, const ScalarPort& port) {
  const TypeLayout& layout =
      port.is_result ? compiled.top.result : compiled.top.parameters[port.argument].layout;
  std::vector<bool> bits((port.width + 3) / 4 * 4, false);
  for (const Leaf& leaf : layout.leaves)
    for (unsigned i = 0; i < leaf.width; ++i) {
      long bit = (static_cast<long>(leaf.byte_offset) - static_cast<long>(port.byte_offset)) * 8 + i;
      if (bit >= 0 && bit < static_cast<long>(port.width)) bits[bit] = true;
    }
  std::string text;
  for (std::size_t i = bits.size(); i > 0; i -= 4)
    text += "0123456789abcdef"[bits[i - 1] << 3 | bits[i - 2] << 2 | bits[i - 3] << 1 | int{bits[i - 4]}];
  return text;
}

std::string native_program(const CompileResult& compiled, const CompileOptions& options,
                           const Steering& steering, std::uint64_t seed) {
  return NativeProgram(compiled, options, steering).text(seed);
}

}  // namespace hlsc::differential
