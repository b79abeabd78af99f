#include "io/xml_stream.h"

#include <cstddef>
#include <exception>
#include <new>
#include <utility>

#include <expat.h>
#include <fmt/format.h>

#include "io/input_error.h"

namespace flexslip {
namespace {

constexpr char between = '|';  // a namespace and a name

std::string_view local(std::string_view name) { return name.substr(name.rfind(between) + 1); }

}  // namespace

std::optional<std::string_view> XmlAttributes::find(std::string_view name) const {
  for (const char** pair = pairs_; *pair != nullptr; pair += 2)
    if (local(pair[0]) == name) return pair[1];
  return std::nullopt;
}

struct XmlStream::Parser {
  XmlHandlers handlers;
  XML_Parser parser = XML_ParserCreateNS(nullptr, between);
  std::exception_ptr thrown{};  // by a handler, or here: not through the C of the parser

  template <class Call>
  static void guarded(void* user, const Call& call) {
    Parser& self = *static_cast<Parser*>(user);
    if (self.thrown) return;
    try {
      call(self);
    } catch (...) {
      self.thrown = std::current_exception();
      XML_StopParser(self.parser, XML_FALSE);
    }
  }
};

XmlStream::XmlStream(XmlHandlers handlers) : parser_(std::make_unique<Parser>()) {
  parser_->handlers = std::move(handlers);
  XML_ParserStruct* const parser = parser_->parser;
  if (parser == nullptr) throw std::bad_alloc();
  XML_SetUserData(parser, parser_.get());
  XML_SetElementHandler(
      parser,
      [](void* user, const char* name, const char** attributes) {
        Parser::guarded(user, [&](Parser& self) { self.handlers.begin(local(name), XmlAttributes(attributes)); });
      },
      [](void* user, const char* name) {
        Parser::guarded(user, [&](Parser& self) { self.handlers.end(local(name)); });
      });
  XML_SetCharacterDataHandler(parser, [](void* user, const char* text, int length) {
    Parser::guarded(user, [&](Parser& self) { self.handlers.text({text, static_cast<std::size_t>(length)}); });
  });
  XML_SetStartDoctypeDeclHandler(parser, [](void* user, const char*, const char*, const char*, int) {
    Parser::guarded(user, [](Parser&) {
      throw InputError({.expected = "a workbook as spreadsheet programs write it",
                        .found = "a document type in its XML",
                        .remedy = "save it anew in the spreadsheet program"});
    });
  });
}

XmlStream::~XmlStream() { XML_ParserFree(parser_->parser); }

void XmlStream::feed(std::string_view piece) { parse(piece, false); }

void XmlStream::finish() { parse({}, true); }

void XmlStream::parse(std::string_view piece, bool is_last) {
  const XML_Status status =
      XML_Parse(parser_->parser, piece.data(), static_cast<int>(piece.size()), is_last ? XML_TRUE : XML_FALSE);
  if (parser_->thrown) std::rethrow_exception(parser_->thrown);
  if (status == XML_STATUS_OK) return;
  throw InputError({.expected = "a whole workbook",
                    .found = fmt::format("broken XML in it ({})", XML_ErrorString(XML_GetErrorCode(parser_->parser))),
                    .remedy = "save it anew in the spreadsheet program"});
}

}  // namespace flexslip
