#pragma once

#include <lodsmith/core/LodChain.h>
#include <lodsmith/core/Simplify.h>
#include <lodsmith/loddef/LodDefinition.h>
#include <lodsmith/ogre/LodManager.h>

#include <cstddef>

/// The tables of constants of docs/lua.md: their names in Lua for the types of the library. Metric and StopReason are called so.
namespace lodsmith::lua {

using Strategy = LodStrategy;
using Type = LodDefinitionType;
using Method = LevelTarget::Kind;
using Decision = LodDecision;

namespace limits {

constexpr std::size_t maxLevels = kMaxLoddefLevels;
constexpr double maxValue = 1e18; // LodLevelDefinition::value
constexpr std::size_t maxMeshNameBytes = kMaxMeshNameBytes;

} // namespace limits
} // namespace lodsmith::lua
