#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace camwright {

enum class TextLanguage : std::uint8_t { English, Chinese, Russian };

/// "en", "zh", "ru"; anything else is English.
TextLanguage textLanguage(std::string_view code);

/// A text of a family's data in the three languages. A vendor's error text may have English only; `in` falls back to it.
struct Text {
    std::string en, zh, ru;

    const std::string& in(TextLanguage language) const
    {
        const std::string& wanted = language == TextLanguage::Chinese ? zh : language == TextLanguage::Russian ? ru : en;
        return wanted.empty() ? en : wanted;
    }
    bool isComplete() const { return !en.empty() && !zh.empty() && !ru.empty(); }
    bool operator==(const Text&) const = default;
};

} // namespace camwright
