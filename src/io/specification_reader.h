// Reader of specifications.
#pragma once

#include "io/element_reader.h"

namespace rubber_suspension::io {

class SpecificationReader : public ElementReader {
 protected:
  using ElementReader::ElementReader;

  /// Reads a component of any model except `elements`.
  ComponentDescription loadSpecification(const Entry& entry, estimation::Model model, const Entry& add);

  std::vector<element::ElementDescription> loadAdded(const Entry& add, const estimation::Specification& specification);

  std::optional<component::Preload> preload_;  ///< preload of the direction being read

 private:
  void preloadSpecification(const Entry& entry, estimation::Specification& specification) const;
  estimation::Specification loadValues(const Entry& entry, const std::vector<std::string>& others);
  void loadDescribed(const Entry& entry, estimation::Specification& specification);
  estimation::SheetTolerance loadSheetTolerance(const Entry& entry, const estimation::Specification& specification);
  estimation::StaticCurve loadCurve(const Entry& entry, const Entry& scale);
  estimation::SpecifiedPoint loadPoint(const Entry& entry);
  [[noreturn]] void refuseSpecification(const Entry& map, const std::string& message) const;
};

}  // namespace rubber_suspension::io
