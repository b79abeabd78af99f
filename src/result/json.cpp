#include "result/json.h"

#include "io/text_file.h"

namespace flexslip {

void write_json(const std::string& path, const Json& json) {
  write_text(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");  // file names may be no UTF-8
}

}  // namespace flexslip
