// Runs a job on untrusted input in a child process with limits on its time and memory.
// In: the job, what it may use. Out: the bytes that it wrote, or one sentence why there are none. The caller's process cannot be harmed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace lightbench::importer {

// What reading `input_bytes` may take from now on. A small malformed file is refused within a second and 256 MiB.
struct Allowance {
    std::size_t memory = 0; // bytes of address space beyond what is mapped now
    double cpu_seconds = 0;
    double wall_seconds = 0;
};
Allowance allowance_for(std::uint64_t input_bytes);

// In the child only: sets the limits, counted from now. Called again when the job learns that the input has further files.
void grant(const Allowance& allowance);

// Bytes that a child left; owns the memory they lie in.
class ChildOutput {
  public:
    ChildOutput(int memory_file, std::optional<std::string> failure);
    ~ChildOutput();
    ChildOutput(ChildOutput&&) noexcept;
    ChildOutput& operator=(ChildOutput&&) = delete;
    std::span<const std::uint8_t> bytes() const { return {data, size}; }
    const std::optional<std::string>& failure() const { return why; }

  private:
    const std::uint8_t* data = nullptr;
    std::size_t size = 0;
    std::optional<std::string> why;
};

// `job` writes its result to the file descriptor it is given; it may throw std::bad_alloc. Throws std::system_error if no child can be made.
ChildOutput run_in_child(const Allowance& allowance, const std::function<void(int)>& job);

} // namespace lightbench::importer
