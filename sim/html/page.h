// One self-contained HTML page: style, script and data in one file, which fetches nothing.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace artu::sim {

/// `data` is what the script draws (docs/report.md says what is in it).  Its names may hold anything: they end neither
/// the script nor the page.  The page's Content-Security-Policy (W3C, level 3) allows its own script by its SHA-256,
/// and no other.
std::string html_page(const std::string& title, const nlohmann::ordered_json& data);

/// JSON for a <script> element: no '<', '>' or '&', and no line ends that JavaScript knows and JSON does not.
std::string json_in_html(const nlohmann::ordered_json& data);

/// With padding (RFC 4648, section 4).
std::string base64(std::string_view bytes);

}  // namespace artu::sim
