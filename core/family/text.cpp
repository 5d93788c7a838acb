#include "core/family/text.h"

namespace camwright {

TextLanguage textLanguage(std::string_view code)
{
    if (code == "zh" || code.starts_with("zh_") || code.starts_with("zh-"))
        return TextLanguage::Chinese;
    if (code == "ru" || code.starts_with("ru_") || code.starts_with("ru-"))
        return TextLanguage::Russian;
    return TextLanguage::English;
}

} // namespace camwright
