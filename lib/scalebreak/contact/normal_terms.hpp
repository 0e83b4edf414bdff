#pragma once

#include <array>
#include <string_view>
#include <variant>

namespace scalebreak {

/// Where an adhesive contact ends: at the tear-off fold, at the force minimum, or at zero overlap.
enum class AdhesionRange { full, pull_off, touch };

/// What the normal dashpot grows with.
enum class DampingOn { overlap, contact_radius };

/// The regular coordinate x of a normal law: the overlap δ, of a contact without a radius; (R*δ)^{1/4}, of which the contact radius a
/// follows; or √a, of a contact that does not touch with dδ/dx = 0.
enum class Coordinate { overlap, overlap_root, radius_root };

/// What a normal law is, beside its numbers.
struct NormalTraits {
  std::string_view name;                              ///< its word in inputs and outputs; the forms of one law share it
  std::string_view without_adhesion = {};             ///< of an adhesive law: the name of the law that it is without surface energy
  AdhesionRange furthest_end = AdhesionRange::touch;  ///< it may end there, or at those named after it
  DampingOn damping_on = DampingOn::overlap;          ///< of this form's dashpot
  Coordinate coordinate = Coordinate::overlap_root;
  bool constant_spring = false;  ///< its spring is the material's spring_constant at any overlap; else it stiffens, and is made of E*

  [[nodiscard]] constexpr bool adhesive() const { return !without_adhesion.empty(); }
};

/// What one unit of each reduced quantity is, SI.
template <class T>
struct ReducedScales {
  T coordinate;  ///< of √a [m^{1/2}], or of the overlap [m] for a contact without a radius
  T overlap;     ///< [m]
  T time;        ///< [s]
  T force;       ///< [N]

  [[nodiscard]] T speed() const { return overlap / time; }
};

/// A law without its scalar.
template <template <class> class Law>
struct LawForm {
  template <class T>
  using Of = Law<T>;
};

/// A list of laws, and what follows from it.
template <template <class> class... Laws>
struct LawList {
  using Law = std::variant<Laws<double>...>;    ///< any of them
  using Form = std::variant<LawForm<Laws>...>;  ///< the same without numbers, to be visited
  static constexpr std::size_t count = sizeof...(Laws);
  static constexpr std::array<Form, count> forms = {LawForm<Laws>{}...};
  static constexpr std::array<NormalTraits, count> traits = {Laws<double>::traits...};
};

}  // namespace scalebreak
