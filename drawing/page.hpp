// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <stdexcept>
#include <string>

namespace limpet::drawing {

/// The program was built without the page.
class NoPage : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws NoPage, with one line that says what to install, when this program was built without the page.
void require_page();

/// One HTML file that shows `data` (PageData::bytes()) in any browser, with all that it needs. The same
/// arguments give the same bytes. `title`: any text. Throws NoPage.
std::string page(const std::string& title, const std::string& data);

/// The bytes in gzip's form, the same on every machine; no time is in it.
std::string gzipped(const std::string& bytes);
/// In letters, digits, + and / (RFC 4648), padded.
std::string base64(const std::string& bytes);
/// Text for HTML and XML: & < > " ' as character references.
std::string html_text(const std::string& text);

}  // namespace limpet::drawing
