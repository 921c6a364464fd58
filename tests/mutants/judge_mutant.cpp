// Only what is new counts: an error that the scene had before the mutation is left out of account. The mutated author's own
// are errors at its node, its fields or its code. An error elsewhere is in order where it is a consequence: another effect that
// is left out and whose message leads, over one or several others, to the mutated one. A mutant may be legal code that merely
// no longer has what others need (a function of another name): then those complain, and the mutated author is not at fault. And
// its code may be legal in each part, but no longer fit from part to part: then the other part is as good a place to say so.

#include "mutants/judge_mutant.h"

#include <algorithm>
#include <map>

#include "support/compile_text.h"

namespace plugc::mutants {
namespace {

bool lies_in(const Span& span, const Span& whole) {
  return span.valid() && span.source == whole.source && whole.begin <= span.begin && span.begin <= whole.end;
}

/// The places of a part's text. Text with escapes is in several pieces; from the first to the last, all is the part's.
Span whole_of(const MappedText& text) {
  if (text.empty()) return {};
  const Span first = text.locate(0, 1);
  const Span last = text.locate(text.size() - 1, text.size());
  return first.valid() && first.source == last.source ? join(first, last) : Span{};
}

/// Whether the place belongs to the author: its node's type, one of its fields, its code or the url of that.
bool is_of(const SceneEffect& node, const Span& span) {
  const bool in_code = std::any_of(node.parts.begin(), node.parts.end(), [&](const ShaderSource& part) {
    return lies_in(span, part.span) || lies_in(span, whole_of(part.text));
  });
  const bool at_field =
      std::any_of(node.fields.begin(), node.fields.end(), [&](const ShaderField& field) { return lies_in(span, field.span); });
  return in_code || at_field || lies_in(span, node.span);
}

bool is_of_any(const CheckedScene& scene, const Authors& authors, const Span& span) {
  return std::any_of(authors.begin(), authors.end(), [&](const Author& author) { return is_of(scene.node(author), span); });
}

/// What was not said before.
std::vector<const Diagnostic*> new_messages(const CheckedScene& before, const CheckedScene& after) {
  const auto key = [](const CheckedScene& scene, const Diagnostic& said) {
    return message_line(said, *scene.sources, scene.sources->name({0}));
  };
  std::map<std::string, int> known;
  for (const Diagnostic& said : before.diagnostics->all()) ++known[key(before, said)];
  std::vector<const Diagnostic*> messages;
  for (const Diagnostic& said : after.diagnostics->all()) {
    if (--known[key(after, said)] < 0) messages.push_back(&said);
  }
  return messages;
}

bool is_error(const Diagnostic* said) {
  return diagnostic_kind(said->id).severity == Severity::error;
}

/// The mutated authors, and those that are reported to go because of them.
Authors with_consequences(const CheckedScene& after, const std::vector<const Diagnostic*>& messages, Authors authors) {
  const Authors all = after.authors();
  for (bool grew = true; grew;) {
    grew = false;
    for (const Diagnostic* said : messages) {
      const bool has_cause = std::any_of(said->related.begin(), said->related.end(),
                                         [&](const RelatedPlace& place) { return is_of_any(after, authors, place.span); });
      if (!has_cause) continue;
      for (const Author& author : all) {
        if (is_of(after.node(author), said->span)) grew = authors.insert(author).second || grew;
      }
    }
  }
  return authors;
}

/// Whoever needed one of the authors, over one or several others.
Authors with_dependents(const CheckedScene& before, Authors authors) {
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& [author, provider] : before.needs) {
      if (authors.contains(provider)) grew = authors.insert(author).second || grew;
    }
  }
  return authors;
}

/// The mutated part.
Span part_of(const CheckedScene& scene, const Authors& mutated, const Mutation& mutation) {
  for (const Author& author : mutated) {
    for (const ShaderSource& part : scene.node(author).parts) {
      const Span whole = whole_of(part.text);
      if (whole.valid() && lies_in(mutation.token, whole)) return whole;
    }
  }
  return {};
}

/// The part's lines, from the mutated token's on.
Span rest_of_part(const CheckedScene& after, Span part, const Mutation& mutation) {
  const std::string_view text = after.sources->text(mutation.token.source);
  const std::size_t line = mutation.token.begin == 0 ? std::string_view::npos : text.rfind('\n', mutation.token.begin - 1);
  if (line != std::string_view::npos) part.begin = std::max(part.begin, static_cast<std::uint32_t>(line + 1));
  return part;
}

std::uint32_t line_of(const CheckedScene& scene, const Span& span) {
  return scene.sources->position(span.source, span.begin).line;
}

}  // namespace

Authors authors_at(const CheckedScene& scene, const Span& place) {
  Authors found;
  for (const Author& author : scene.authors()) {
    const auto& parts = scene.node(author).parts;
    const bool here =
        std::any_of(parts.begin(), parts.end(), [&](const ShaderSource& part) { return lies_in(place, whole_of(part.text)); });
    if (here) found.insert(author);
  }
  return found;
}

Judgement judge(const CheckedScene& before, const CheckedScene& after, const Mutation& mutation) {
  Judgement judgement;
  const Authors mutated = authors_at(before, mutation.token);
  std::vector<const Diagnostic*> errors = new_messages(before, after);
  const Authors gone = with_consequences(after, errors, mutated);
  std::erase_if(errors, [](const Diagnostic* said) { return !is_error(said); });
  const Span part = part_of(after, mutated, mutation);
  const Span rest = rest_of_part(after, part, mutation);
  bool in_part = false;
  for (const Diagnostic* said : errors) {
    judgement.died = judgement.died || said->id == DiagnosticId::validation_died;
    judgement.named = judgement.named || is_of_any(after, mutated, said->span);
    in_part = in_part || lies_in(said->span, part);
    judgement.placed = judgement.placed || lies_in(said->span, rest);
    judgement.exact =
        judgement.exact || (lies_in(said->span, rest) && line_of(after, said->span) == line_of(after, mutation.token));
  }
  judgement.placed = judgement.placed || (judgement.named && !in_part);
  const Authors dependents = with_dependents(before, gone);
  for (const Diagnostic* said : errors) {
    if (is_of_any(after, gone, said->span)) continue;
    const bool consequence = is_of_any(after, dependents, said->span);
    if (!consequence) judgement.outside.push_back(message_line(*said, *after.sources, after.sources->name({0})));
    judgement.uncaused = judgement.uncaused || (consequence && judgement.named);
  }
  for (std::size_t shape = 0; shape < std::min(before.drawn.size(), after.drawn.size()); ++shape) {
    for (const Author& author : before.drawn[shape]) {
      if (!after.drawn[shape].contains(author) && !dependents.contains(author))
        judgement.lost.push_back(before.node(author).label);
    }
  }
  judgement.refused = judgement.named || !judgement.outside.empty() || !judgement.lost.empty();
  return judgement;
}

}  // namespace plugc::mutants
