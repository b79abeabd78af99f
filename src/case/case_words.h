// The words of a case file that stand for something, for reading and writing them.
#pragma once

#include <stdexcept>
#include <string>

#include "case/keys.h"

namespace flexslip {

inline constexpr Words<FrictionModel, 8> friction_model_names{{
    {"constant", FrictionModel::constant},
    {"drift", FrictionModel::drift},
    {"sinusoid", FrictionModel::sinusoid},
    {"sinusoids", FrictionModel::sinusoids},
    {"table", FrictionModel::table},
    {"rough", FrictionModel::rough},
    {"surface", FrictionModel::surface},
    {"roughness", FrictionModel::roughness},
}};

inline constexpr Words<TraceDirection, 2> direction_names{
    {{"outwards", TraceDirection::outwards}, {"inwards", TraceDirection::inwards}}};

inline constexpr Words<SnapRest, 2> snap_names{
    {{"nearest", SnapRest::nearest_stable}, {"overshoot", SnapRest::overshoot}}};

inline constexpr Words<DisplacementOf, 2> displacement_names{
    {{"crosshead", DisplacementOf::crosshead}, {"deflection", DisplacementOf::deflection}}};

inline constexpr Words<SignRule, 3> sign_names{
    {{"find", SignRule::find}, {"keep", SignRule::keep}, {"reverse", SignRule::reverse}}};

inline constexpr Words<bool, 2> failure_names{{{"find", true}, {"none", false}}};

template <std::size_t count, class Value>
std::string name_in(const Words<Value, count>& names, Value value) {
  for (const auto& [name, named] : names)
    if (named == value) return std::string(name);
  throw std::invalid_argument("a value without a name");
}

}  // namespace flexslip
