#include "engine/gpu/fold_constants.h"

#include <gtest/gtest.h>

#include <array>
#include <initializer_list>
#include <utility>
#include <vector>

#include "engine/gpu/spirv.h"

namespace nacre::gpu {
namespace {

using namespace spirv;
using Modules = std::vector<std::uint32_t>;

enum Id : std::uint32_t {
    kBool = 1,
    kInt,
    kSwitch,
    kLevel,
    kTwo,
    kHigh,
    kBoth,
    kFunction,
    kHead,
    kThen,
    kElse,
    kEnd,
    kPhi,
    kOut,
    kOther
};

/// if (kSwitch && kLevel > 2) ... else ..., and a phi of both. @param compares  kLevel with 2
Modules module(std::uint32_t compares = kOpSGreaterThan) {
    Modules m = {0x07230203, 0x00010300, 0, 100, 0};
    append(m, kOpEntryPoint, {0, kFunction, 0x6e69616d, 0, kOut, kOther});  // of a vertex stage, "main"
    append(m, kOpName, {kThen, 0x74});
    append(m, kOpDecorate, {kOut, 30, 0});  // Location
    append(m, kOpDecorate, {kOther, 30, 1});
    append(m, kOpDecorate, {kSwitch, 1, 3});
    append(m, kOpDecorate, {kLevel, 1, 8});
    append(m, kOpTypeInt, {kInt, 32, 1});
    append(m, kOpSpecConstantFalse, {kBool, kSwitch});
    append(m, kOpSpecConstant, {kInt, kLevel, 5});
    append(m, kOpConstant, {kInt, kTwo, 2});
    append(m, kOpSpecConstantOp, {kBool, kHigh, compares, kLevel, kTwo});
    append(m, kOpSpecConstantOp, {kBool, kBoth, kOpLogicalAnd, kSwitch, kHigh});
    append(m, kOpVariable, {98, kOut, 3});  // outputs
    append(m, kOpVariable, {98, kOther, 3});
    append(m, kOpFunction, {kInt, kFunction, 0, 99});
    append(m, kOpLabel, {kHead});
    append(m, kOpSelectionMerge, {kEnd, 0});
    append(m, kOpBranchConditional, {kBoth, kThen, kElse});
    append(m, kOpLabel, {kThen});
    append(m, kOpStore, {kOut, kTwo});
    append(m, kOpBranch, {kEnd});
    append(m, kOpLabel, {kElse});
    append(m, kOpStore, {kOther, kTwo});
    append(m, kOpPhi, {kInt, 50, kTwo, kHead});
    append(m, kOpBranch, {kEnd});
    append(m, kOpLabel, {kEnd});
    append(m, kOpPhi, {kInt, kPhi, kTwo, kThen, kLevel, kElse});
    append(m, kOpReturnValue, {kPhi});
    append(m, kOpFunctionEnd, {});
    return m;
}

/// Where the block `kHead` branches to; 0: it has two ends.
std::uint32_t target(const Modules& m) {
    const Instruction head = require(
        m, kHeader, "head", [](const Instruction& i) { return i.operation == kOpLabel && i.operands[0] == kHead; });
    const Instruction end = require(m, head.end(), "end", [](const Instruction&) { return true; });
    return end.operation == kOpBranch ? end.operands[0] : 0;
}

Modules fold(std::initializer_list<std::pair<int, int>> constants) {
    Specialization given;
    for (const auto& [id, value] : constants) given.set(id, value);
    return foldConstants(module(), given);
}

TEST(FoldConstants, TakesTheBranchOfGivenConstants) {
    EXPECT_EQ(target(fold({})), kElse);  // the module's own values
    EXPECT_EQ(target(fold({{3, 1}})), kThen);
    EXPECT_EQ(target(fold({{3, 1}, {8, 2}})), kElse);
    EXPECT_EQ(target(fold({{3, 1}, {8, -3}})), kElse);
    EXPECT_EQ(target(fold({{3, 0}, {8, 9}})), kElse);
}

TEST(FoldConstants, ComparesIntegers) {
    struct Row {
        std::uint32_t operation;
        std::array<bool, 4> holds;  // -1, 1, 2, 3 beside 2
    };
    constexpr Row kRows[] = {
        {kOpIEqual, {false, false, true, false}},          {kOpINotEqual, {true, true, false, true}},
        {kOpUGreaterThan, {true, false, false, true}},     {kOpSGreaterThan, {false, false, false, true}},
        {kOpUGreaterThanEqual, {true, false, true, true}}, {kOpSGreaterThanEqual, {false, false, true, true}},
        {kOpULessThan, {false, true, false, false}},       {kOpSLessThan, {true, true, false, false}},
        {kOpULessThanEqual, {false, true, true, false}},   {kOpSLessThanEqual, {true, true, true, false}},
    };
    constexpr int kLevels[] = {-1, 1, 2, 3};
    for (const Row& row : kRows)
        for (std::size_t i = 0; i < 4; ++i) {
            Specialization given;
            given.set(3, 1);
            given.set(8, kLevels[i]);
            EXPECT_EQ(target(foldConstants(module(row.operation), given)), row.holds[i] ? kThen : kElse)
                << row.operation << ", " << kLevels[i];
        }
}

bool names(const Modules& m, std::uint32_t operation, std::uint32_t id, std::size_t operand) {
    return find(m, kHeader,
                [&](const Instruction& i) {
                    return i.operation == operation && i.operands.size() > operand && i.operands[operand] == id;
                })
        .has_value();
}

TEST(FoldConstants, DropsWhatNothingReaches) {
    const auto isPhi = [](const Instruction& i) { return i.operation == kOpPhi; };
    const Modules otherwise = fold({}), then = fold({{3, 1}});
    for (const Modules* m : {&otherwise, &then}) {
        const bool takes = m == &then;
        EXPECT_EQ(names(*m, kOpLabel, kThen, 0), takes);
        EXPECT_EQ(names(*m, kOpLabel, kElse, 0), !takes);
        EXPECT_EQ(names(*m, kOpName, kThen, 0), takes);
        EXPECT_EQ(names(*m, kOpVariable, kOut, 1), takes);
        EXPECT_EQ(names(*m, kOpVariable, kOther, 1), !takes);
        EXPECT_EQ(names(*m, kOpDecorate, kOut, 0), takes);
        EXPECT_EQ(names(*m, kOpDecorate, kOther, 0), !takes);
        const Instruction entry =
            require(*m, kHeader, "entry", [](const Instruction& i) { return i.operation == kOpEntryPoint; });
        ASSERT_EQ(entry.operands.size(), 5u);
        EXPECT_EQ(entry.operands[4], takes ? kOut : kOther);
    }
    const Instruction dead = require(otherwise, kHeader, "phi", isPhi);  // of kElse, which kHead leads to
    EXPECT_EQ(dead.operands.size(), 4u);
    EXPECT_EQ(require(otherwise, dead.end(), "phi", isPhi).operands[3], kElse);
    const Instruction end = require(then, kHeader, "phi", isPhi);
    ASSERT_EQ(end.operands.size(), 4u);
    EXPECT_EQ(end.operands[3], kThen);
}

TEST(FoldConstants, KeepsStagesWithoutKnownConditions) {
    Modules m = module();
    const Instruction number = require(m, kHeader, "number", [](const Instruction& i) {
        return i.operation == kOpDecorate && i.operands[0] == kSwitch;
    });
    m[number.at + 2] = 7;  // another decoration: the constant has no number
    Specialization given;
    given.set(3, true);
    EXPECT_EQ(target(foldConstants(m, given)), kElse);
    Modules plain = module();
    const Instruction branch =
        require(plain, kHeader, "branch", [](const Instruction& i) { return i.operation == kOpBranchConditional; });
    plain[branch.at + 1] = 77;  // a condition from elsewhere
    EXPECT_EQ(foldConstants(plain, given), plain);
}

}  // namespace
}  // namespace nacre::gpu
