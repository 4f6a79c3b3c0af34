#include "app/picture/interaction_values.h"

#include <gtest/gtest.h>

#include "engine/error.h"

namespace nacre::app {
namespace {

std::string read(const char* text) {
    ContactOptions contacts;
    parseInteractions(text, contacts);
    return contacts.of ? contacts.of->text + "|" + (contacts.with ? contacts.with->text : "") : "off";
}

TEST(InteractionValues, OneSelectionOrTwo) {
    EXPECT_EQ(read("ligand"), "ligand|");
    EXPECT_EQ(read("ligand,protein"), "ligand|protein");
    EXPECT_EQ(read("chain A,B"), "chain A,B|");  // a list of one selection
    EXPECT_EQ(read("resn HEM,CMO,chain A and protein"), "resn HEM,CMO|chain A and protein");
    EXPECT_EQ(read("off"), "off");
    EXPECT_THROW(read("chain"), Error);
    EXPECT_THROW(read("ligand,"), Error);
}

TEST(InteractionValues, RulesAndKindsByTheirNames) {
    EXPECT_EQ(parseInteractionRules("wernet-nilsson"), InteractionRules::wernetNilsson);
    EXPECT_THROW(parseInteractionRules("probe"), std::invalid_argument);
    EXPECT_EQ(interactionKindsText(parseInteractionKinds("all")), "all");
    EXPECT_EQ(interactionKindsText(parseInteractionKinds("metal,hydrogen-bond")), "hydrogen-bond,metal");
    EXPECT_THROW(parseInteractionKinds("metals"), std::invalid_argument);
    EXPECT_THROW(parseInteractionKinds(""), std::invalid_argument);
}

}  // namespace
}  // namespace nacre::app
