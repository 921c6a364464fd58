#pragma once
// Template shaders, cut to what a shape uses. Templates are plain GLSL whose `#ifdef FEATURE` lines are resolved here, so
// that composed text holds no trace of what it does not need, and whose names with a capital N (`castle_texture_N`,
// `castle_LightSourceNColor`, `light_source_N`) are numbered.

#include <algorithm>
#include <compare>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "compose/code_unit.h"

namespace plugc {

/// Names of what a template is to hold. Few, and always noted in one order: a list is quicker than a set.
class Features {
 public:
  Features() = default;
  Features(std::initializer_list<std::string_view> names) : names_(names) {}
  void insert(std::string_view name) { names_.push_back(name); }
  bool contains(std::string_view name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }
  const std::vector<std::string_view>& names() const { return names_; }

 private:
  std::vector<std::string_view> names_;
};

/// Lines kept by `#ifdef`/`#ifndef`/`#else`/`#endif` on feature names, which nest. Mapped to the template's own text.
MappedText cut_template(const SourceSet& sources, SourceId source, const Features& features);

/// The text with its N names numbered.
MappedText number_names(const MappedText& text, int number);

/// Hands out cut, numbered and outlined templates. Each form is made once in a process, whoever asks: it depends on nothing
/// else, and takes half of the time of composing a small scene. A source set gets a template's text when it is first asked for.
class TemplateLibrary {
 public:
  explicit TemplateLibrary(SourceSet& sources) : sources_(&sources) {}
  /// `name` below `templates/`, e.g. `phong.frag`, or with its folder, e.g. `shadows/pcf.glsl`; `number` -1 for none.
  std::shared_ptr<const CodeUnit> get(std::string_view name, const Features& features, int number = -1);

 private:
  SourceId source(std::string_view name);
  SourceSet* sources_;
  std::map<std::string, SourceId, std::less<>> loaded_;
};

}  // namespace plugc
