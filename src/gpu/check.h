// CHECK(a == b): what must hold if our own code is right. Otherwise prints the expression with both values, then aborts.
// CHECK(a == b, "while {}", x) adds a sentence (fmt). No Vulkan here.
#pragma once

#include <concepts>
#include <fmt/format.h>
#include <string>
#include <type_traits>

namespace lightbench::check_detail {

// A value as people read it; types without a formatter are only named.
template <class T> std::string show(const T& value) {
    if constexpr (std::is_enum_v<T>)
        return fmt::format("{}", static_cast<std::underlying_type_t<T>>(value));
    else if constexpr (std::is_pointer_v<T>)
        return value ? fmt::format("{}", static_cast<const void*>(value)) : "null";
    else if constexpr (fmt::is_formattable<T>::value)
        return fmt::format("{}", value);
    else
        return "(value)";
}

struct Outcome {
    bool holds;
    std::string values; // empty if it holds
};

template <class T> struct Left {
    const T& left;
    template <class R> Outcome judge(bool holds, const char* op, const R& right) const {
        return {holds, holds ? std::string() : fmt::format("{} {} {}", show(left), op, show(right))};
    }
    template <class R> Outcome operator==(const R& right) const { return judge(left == right, "==", right); }
    template <class R> Outcome operator!=(const R& right) const { return judge(left != right, "!=", right); }
    template <class R> Outcome operator<(const R& right) const { return judge(left < right, "<", right); }
    template <class R> Outcome operator<=(const R& right) const { return judge(left <= right, "<=", right); }
    template <class R> Outcome operator>(const R& right) const { return judge(left > right, ">", right); }
    template <class R> Outcome operator>=(const R& right) const { return judge(left >= right, ">=", right); }
    operator Outcome() const { return {static_cast<bool>(left), static_cast<bool>(left) ? std::string() : show(left)}; }
};

// `Begin() << a == b` parses as `(Begin() << a) == b`: the left side is caught before the comparison.
struct Begin {
    template <class T> Left<T> operator<<(const T& left) const { return {left}; }
};

[[noreturn]] void fail(const char* file, int line, const char* expression, const std::string& values, const std::string& sentence);

inline std::string sentence() {
    return {};
}
template <class... Args> std::string sentence(fmt::format_string<Args...> format, Args&&... args) {
    return fmt::format(format, std::forward<Args>(args)...);
}

} // namespace lightbench::check_detail

// clang takes the catching of the left side for a mistake in precedence.
#ifdef __clang__
#define LIGHTBENCH_CHECK_QUIET _Pragma("clang diagnostic push") _Pragma("clang diagnostic ignored \"-Woverloaded-shift-op-parentheses\"")
#define LIGHTBENCH_CHECK_LOUD _Pragma("clang diagnostic pop")
#else
#define LIGHTBENCH_CHECK_QUIET
#define LIGHTBENCH_CHECK_LOUD
#endif

#define CHECK(expression, ...)                                                                                                             \
    do {                                                                                                                                   \
        LIGHTBENCH_CHECK_QUIET                                                                                                             \
        if (const ::lightbench::check_detail::Outcome check_outcome = ::lightbench::check_detail::Begin() << expression;                   \
            !check_outcome.holds)                                                                                                          \
            ::lightbench::check_detail::fail(__FILE__, __LINE__, #expression, check_outcome.values,                                        \
                                             ::lightbench::check_detail::sentence(__VA_ARGS__));                                           \
        LIGHTBENCH_CHECK_LOUD                                                                                                              \
    } while (false)
