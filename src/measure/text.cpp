#include "measure/text.h"

namespace lightbench {
namespace {

unsigned char byte_at(std::string_view text, std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

// Bytes of the well-formed character that begins at i, 0 if none does. The Unicode Standard 15, table 3-7.
std::size_t character_length(std::string_view text, std::size_t i) {
    const unsigned first = byte_at(text, i), second = byte_at(text, i + 1);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xc2 && first <= 0xdf ? 2 : (first & 0xf0) == 0xe0 ? 3 : first >= 0xf0 && first <= 0xf4 ? 4 : 0;
    if (length == 0) return 0;
    for (std::size_t k = 1; k < length; ++k)
        if ((byte_at(text, i + k) & 0xc0) != 0x80) return 0;
    const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool beyond = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
    return overlong || beyond ? 0 : length;
}

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

} // namespace

std::string printable(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = character_length(text, i);
        const unsigned char c = byte_at(text, i);
        if (length == 0)
            out += '?';
        else if (c < 0x20 || c == 0x7f)
            out += ' ';
        else
            out += text.substr(i, length);
        i += length == 0 ? 1 : length;
    }
    return out;
}

std::string html_escaped(std::string_view text) {
    std::string out;
    for (const char c : printable(text)) {
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '"': out += "&quot;"; break;
        case '\'': out += "&#39;"; break;
        default: out += c;
        }
    }
    return out;
}

std::string gnuplot_quoted(std::string_view text) {
    std::string out = "'";
    for (const char c : printable(text)) {
        if (c == '\'') out += '\'';
        out += c;
    }
    return out + '\'';
}

std::string file_word(std::string_view text) {
    std::string out;
    for (const char c : text.substr(0, 80)) {
        if (is_word(c))
            out += c;
        else if (!out.ends_with('-'))
            out += '-';
    }
    return out.empty() ? "-" : out;
}

} // namespace lightbench
