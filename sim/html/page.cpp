#include "sim/html/page.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "sim/html/assets.h"

namespace artu::sim {
namespace {

/// In the order in which they need each other.
constexpr const char* scripts[] = {"dom.js",      "theme.js", "chart.js",   "table.js", "pictures.js", "cycles.js",
                                   "timeline.js", "run.js",   "compare.js", "sweep.js", "main.js"};

std::string script() {
  std::string text = "\"use strict\";\n(() => {\n";
  for (const char* name : scripts) {
    const std::string_view part = html_asset(name);
    if (part.empty()) throw std::logic_error(std::string("no asset ") + name);
    text += part;
  }
  return text + "})();\n";
}

/// As a Content-Security-Policy names a script or style.
std::string source_of(const std::string& text) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned size = 0;
  if (EVP_Digest(text.data(), text.size(), digest, &size, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("SHA-256 failed");
  }
  return "'sha256-" + base64({reinterpret_cast<const char*>(digest), size}) + "'";
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace

std::string base64(std::string_view bytes) {
  std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');  // and the 0 that EVP writes
  const auto* from = reinterpret_cast<const unsigned char*>(bytes.data());
  const int length =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), from, static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

std::string json_in_html(const nlohmann::ordered_json& data) {
  const std::string json = data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string out;
  out.reserve(json.size() + json.size() / 64);
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '<' || c == '>' || c == '&') {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else if (c == '\xe2' && (json.compare(i, 3, "\xe2\x80\xa8") == 0 || json.compare(i, 3, "\xe2\x80\xa9") == 0)) {
      out += json[i + 2] == '\xa8' ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      out += c;
    }
  }
  return out;
}

std::string html_page(const std::string& title, const nlohmann::ordered_json& data) {
  const std::string code = script(), style(html_asset("report.css"));
  const std::string policy =
      fmt::format("default-src 'none'; img-src data:; script-src {}; style-src {}", source_of(code), source_of(style));
  const std::string_view frame = html_asset("page.html");
  std::string page;
  for (std::size_t at = 0; at < frame.size();) {
    const std::size_t mark = frame.find('@', at);
    page += frame.substr(at, mark - at);
    if (mark == std::string_view::npos) break;
    const std::size_t end = frame.find('@', mark + 1);
    const std::string_view name = frame.substr(mark + 1, end - mark - 1);
    page += name == "TITLE"    ? escaped(title)
            : name == "POLICY" ? policy
            : name == "STYLE"  ? style
            : name == "SCRIPT" ? code
                               : json_in_html(data);
    at = end + 1;
  }
  return page;
}

}  // namespace artu::sim
