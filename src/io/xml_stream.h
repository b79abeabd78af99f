// The elements of an XML document as they come, of any size; what holds them is not kept.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string_view>

namespace flexslip {

// The attributes of an element, by their names without namespace; valid while it begins.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}
  std::optional<std::string_view> find(std::string_view name) const;

 private:
  const char** pairs_;  // name, value, ..., nullptr
};

// What is called for each; names are without namespace. They may throw.
struct XmlHandlers {
  std::function<void(std::string_view name, const XmlAttributes&)> begin;
  std::function<void(std::string_view name)> end;
  std::function<void(std::string_view text)> text;  // in pieces
};

class XmlStream {
 public:
  explicit XmlStream(XmlHandlers handlers);
  ~XmlStream();
  XmlStream(const XmlStream&) = delete;
  XmlStream& operator=(const XmlStream&) = delete;

  // The next piece of the document, and its end.
  // Fails:      InputError, without a file: not well-formed; a document type, which could define entities. Whatever a handler
  //             throws.
  void feed(std::string_view piece);
  void finish();

 private:
  struct Parser;
  void parse(std::string_view piece, bool is_last);
  std::unique_ptr<Parser> parser_;
};

}  // namespace flexslip
