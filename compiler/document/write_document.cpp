#include "document/write_document.h"

namespace plugc {

std::string write_document(const Document& document, Encoding as) {
  switch (as) {
    case Encoding::xml: return write_xml(document);
    case Encoding::json: return write_json(document);
    default: return write_classic(document);
  }
}

}  // namespace plugc
