#pragma once

#include <variant>

#include <scalebreak/contact/contact_kind.hpp>

namespace scalebreak {

/// Any normal law, chosen at run time.
using NormalLaw = NormalLaws::Law;

/// Calls `visitor` with the LawForm of a kind.
template <class Visitor>
decltype(auto) visit_form(const ContactKind& kind, Visitor&& visitor) {
  return std::visit(std::forward<Visitor>(visitor), NormalLaws::forms[normal_form(kind)]);
}

/// The normal law of a pair, SI. The kind must suit the pair: an adhesive law needs surface_energy > 0.
[[nodiscard]] inline NormalLaw normal_law(const ContactKind& kind, const NormalPair& pair) {
  return visit_form(kind, [&]<template <class> class Law>(LawForm<Law>) -> NormalLaw { return Law<double>::make(pair, kind.range); });
}

/// Is a law's dashpot smooth in w = δ^{1/4} and not in its own coordinate? Then it gives it as damping_of_root(w) too, and is `undamped`
/// below zero overlap.
template <class Law>
concept RootDamped = requires(const Law& law) {
  law.damping_of_root(law.touch());
};

}  // namespace scalebreak
