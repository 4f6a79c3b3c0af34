#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/info_command.h"
#include "app/cli/info_interactions.h"
#include "engine/error.h"
#include "engine/molecule/read.h"
#include "engine/scene/instances/copies.h"
#include "tests/support/test_data.h"

namespace nacre::app {
namespace {

Molecule twoAtoms() {
    Molecule molecule;
    molecule.chains = {{"A"}};
    molecule.residues.resize(2);
    molecule.residues[0].number = -3;
    molecule.residues[0].atomCount = 1;
    molecule.residues[1].insertionCode = 'B';
    molecule.residues[1].firstAtom = 1;
    molecule.residues[1].atomCount = 1;
    molecule.atoms.resize(2);
    molecule.atoms[0].position = {7.075f, -1, 2};
    molecule.atoms[1].position = {1, 4, 2.5f};
    molecule.atoms[1].residue = 1;
    molecule.atoms[1].hetero = true;
    molecule.bonds = {{0, 1, 1, BondSource::distance}};
    molecule.file.format = "pdb";
    molecule.file.models = 3;
    molecule.file.title = "A title \x1b[31m\xff";
    molecule.warnings = {"something was odd"};
    return molecule;
}

TEST(Info, ResiduesWithTheirPlaceInTheFold) {
    Molecule molecule = twoAtoms();
    molecule.residues[0].name = Name("ALA");
    molecule.residues[0].secondary = SecondaryStructure::strand;
    molecule.residues[1].name = Name("HOH");
    molecule.statesSecondaryStructure = true;
    const auto list = residueList(molecule);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].dump(),
              R"({"chain":"A","model":1,"number":-3,"insertion":"","name":"ALA","secondary":"strand"})");
    EXPECT_EQ(list[1].dump(), R"({"chain":"A","model":1,"number":0,"insertion":"B","name":"HOH","secondary":null})");
    EXPECT_EQ(residueText(list), "  residues\n    A        -3  ALA   strand\n    A        0B  HOH \n");
}

TEST(Info, TellsWhatTheFileSaysOfItself) {
    Molecule molecule = twoAtoms();
    molecule.file.organism = "Homo sapiens";
    molecule.file.method = "X-ray diffraction";
    molecule.file.chainNames = {{"A", "Protease"}, {"B", "Protease"}, {"C", "DNA"}};
    molecule.file.componentNames = {{"478", "amprenavir"}};
    const auto json = infoJson(molecule);
    EXPECT_EQ(json["organism"], "Homo sapiens");
    EXPECT_EQ(json["method"], "X-ray diffraction");
    EXPECT_EQ(json["chain_names"]["B"], "Protease");
    EXPECT_EQ(json["component_names"]["478"], "amprenavir");
    const std::string text = infoText("a.pdb", json);
    for (const char* words : {"Homo sapiens", "X-ray diffraction", "C: DNA; A, B: Protease", "478: amprenavir"})
        EXPECT_NE(text.find(words), std::string::npos) << text;
}

TEST(Info, CountsWhatTheMoleculeHolds) {
    const auto json = infoJson(twoAtoms());
    EXPECT_EQ(json["format"], "pdb");
    EXPECT_EQ(json["atoms"], 2);
    EXPECT_EQ(json["models"], 3);
    EXPECT_EQ(json["hetatm"], 1);
    EXPECT_EQ(json["altloc_atoms"], 0);
    EXPECT_EQ(json["insertion_code_atoms"], 1);
    EXPECT_EQ(json["negative_resnum_atoms"], 1);
    EXPECT_EQ(json["bonds_known"]["distance"], 1);
    EXPECT_EQ(json["bonds_known"]["single"], 1);
    EXPECT_TRUE(json.at("chains_auth").is_null());
    EXPECT_EQ(json["bbox"].dump(), "[[1.0,-1.0,2.0],[7.075,4.0,2.5]]");  // as written, not as a float widens
}

TEST(Info, TextIsSafeForATerminal) {
    const std::string text = infoText("file.pdb", infoJson(twoAtoms()));
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_NE(text.find("A title"), std::string::npos);
    EXPECT_NE(text.find("something was odd"), std::string::npos);
    EXPECT_NE(text.find("single 1"), std::string::npos);
    EXPECT_NE(text.find("reading     guessed 1 bond: from distances\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("read 2 atoms"), std::string::npos) << "is said above";
}

TEST(Info, ChainsResolutionAndKindsOfBonds) {
    NACRE_NEEDS_DATA();
    // 4HHB by its paper and entry: two alpha chains of 141 residues, two beta chains of 146, four haems, 1.74 Å.
    const Molecule molecule = readMoleculeFile(test::dataFile("4hhb.pdb"));
    const auto json = infoJson(molecule);
    EXPECT_EQ(json["resolution"], 1.74);
    ASSERT_EQ(json["chain_list"].size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& chain = json["chain_list"][i];
        EXPECT_EQ(chain["name"], std::string(1, static_cast<char>('A' + i)));
        EXPECT_EQ(chain["polymer"], "protein");
        EXPECT_EQ(chain["length"], i % 2 == 0 ? 141 : 146);
        EXPECT_EQ(chain["sequence"].get<std::string>().substr(0, 8), i % 2 == 0 ? "VLSPADKT" : "VHLTPEEK");
        EXPECT_EQ(chain["ligands"]["HEM"], 1);
    }
    EXPECT_EQ(json["ligands"].dump(), "{\"HEM\":4}");
    EXPECT_EQ(json["waters"], 221);
    EXPECT_EQ(json["bonds_known"]["to_metals"], 20);  // iron to four nitrogens and a histidine, four times
    const std::string text = infoText("4hhb.pdb", json);
    EXPECT_NE(text.find("resolution  1.74 Å"), std::string::npos) << text;
    EXPECT_NE(text.find("chains A, C: protein, 141 residues"), std::string::npos) << text;
    EXPECT_EQ(infoJson(readMoleculeFile(test::dataFile("1en2.cif")))["bonds_known"]["disulfides"], 8);
    EXPECT_EQ(infoJson(readMoleculeFile(test::dataFile("1bna.cif")))["chain_list"][1]["sequence"], "CGCGAATTCGCG");
}

TEST(Info, ChargesAndBox) {
    NACRE_NEEDS_DATA();
    const auto pqr = infoJson(readMoleculeFile(test::dataFile("3pqr.pqr")));
    EXPECT_NEAR(pqr["partial_charge"].get<double>(), 1, 1e-3);  // a protein's charge is a whole number
    const auto gro = infoJson(readMoleculeFile(test::dataFile("1crn.gro")));
    EXPECT_EQ(gro["box_vectors"].dump(), "[[40.96,0.0,0.0],[0.0,18.65,0.0],[-0.3026,0.0,22.518]]");
    EXPECT_TRUE(infoJson(readMoleculeFile(test::dataFile("small/caffeine.cml"))).at("chain_list").is_null());
}

TEST(Info, BoxesThatRepeatAlongSomeAxes) {
    const auto describeBox = [](const char* pbc) {
        const auto json = infoJson(
            readMolecule("a.xyz", std::string("1\nLattice=\"4 0 0 0 5 0 0 0 30\" pbc=\"") + pbc + "\"\nC 0 0 0\n"));
        EXPECT_EQ(json["box_periodic"].size(), 3u);
        return infoText("a.xyz", json);
    };
    EXPECT_NE(describeBox("T T F").find("Å, which repeats along a and b\n"), std::string::npos);
    EXPECT_NE(describeBox("F F F").find("Å, which does not repeat\n"), std::string::npos);
    EXPECT_EQ(describeBox("T T T").find("repeat"), std::string::npos);
}

// A reader in a loop needs no second form, nor a look at what is there.
TEST(Info, EveryMoleculeHasTheSameKeys) {
    const auto listKeys = [](const nlohmann::ordered_json& json) {
        std::vector<std::string> keys;
        for (const auto& [key, value] : json.items()) keys.push_back(key);
        return keys;
    };
    for (const char* sample : {"dna", "glucose", "buckyball"})
        EXPECT_EQ(listKeys(infoJson(sampleMolecule(sample))), listKeys(infoJson({}))) << sample;
}

// A Kekulé structure, as it is drawn: two thirds of its bonds are single.
TEST(Info, OrdersAreThoseThatPicturesDraw) {
    const auto bonds = infoJson(sampleMolecule("buckyball"))["bonds_known"];
    EXPECT_EQ(bonds["single"], 60);
    EXPECT_EQ(bonds["double"], 30);
    EXPECT_EQ(bonds["aromatic"], 0);
}

TEST(Info, AMoleculeWithoutAtomsHasNoBox) {
    const auto json = infoJson(Molecule{});
    EXPECT_EQ(json["atoms"], 0);
    EXPECT_TRUE(json.at("bbox").is_null());
}

// Every key that the independent counts know, for every file of a format that Nacre reads.
TEST(Info, AgreesWithIndependentCounts) {
    NACRE_NEEDS_DATA();
    const auto expected = nlohmann::json::parse(std::ifstream(test::dataFile("expected.json")));
    // Damaged files of which the tools counted what is left.
    constexpr std::string_view kReadLeniently[] = {
        "bad/crlf.pdb",         "bad/ensemble_error_1.pdb", "bad/ensemble_error_3.pdb", "bad/odd-start.pdb",
        "bad/short-cryst1.pdb", "bad/non-utf8.pdb",         "bad/hetatm_bad.pdb",       "bad/conect-dangling.pdb"};
    int compared = 0;
    for (const auto& [name, whole] : expected["files"].items()) {
        const bool bad = whole.value("bad", false);
        if (bad && std::ranges::find(kReadLeniently, name) == std::end(kReadLeniently)) continue;
        const nlohmann::json& entry = bad ? whole.at("lenient_independent_count") : whole;
        SCOPED_TRACE(name);
        const nlohmann::json json = infoJson(readMoleculeFile(test::dataFile(name)));
        for (const auto& [key, value] : entry.items()) {
            if (key == "bytes" || key == "sha256" || key == "note" || key == "openbabel" || key.starts_with("gemmi_"))
                continue;
            ASSERT_TRUE(json.contains(key)) << key;
            if (key != "bbox") {
                EXPECT_EQ(json[key], value) << key;
                continue;
            }
            for (std::size_t corner = 0; corner < 2; ++corner)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    EXPECT_NEAR(json[key][corner][axis].get<double>(), value[corner][axis].get<double>(), 6e-4) << key;
        }
        ++compared;
    }
    EXPECT_GE(compared, 90);
}

Molecule twoCarbons() {
    Molecule molecule = twoAtoms();
    molecule.atoms[0].name = Name("CA");
    molecule.atoms[1].name = Name("C1");
    molecule.residues[0].name = Name("ALA");
    molecule.residues[1].name = Name("LIG");
    return molecule;
}

Interaction makeContact(const Molecule& molecule) {
    Interaction contact;
    contact.kind = InteractionKind::waterBridge;
    contact.a = {{1}, molecule.atoms[1].position};
    contact.b = {{0}, molecule.atoms[0].position};
    contact.distance = 3.14159;
    contact.angles = {{"water", 101.26}};
    contact.donor = DonorSide::b;
    contact.waters = {0};
    return contact;
}

TEST(Info, InteractionsAsJsonCsvAndText) {
    const Molecule molecule = twoCarbons();
    const std::vector<Interaction> found = {makeContact(molecule)};
    EXPECT_EQ(interactionList(molecule, found).dump(),
              R"([{"kind":"water-bridge","a":{"chain":"A","model":1,"residue":"LIG","number":0,"insertion":"B",)"
              R"("atoms":["C1"],"ids":[2],"other_copy":false},"b":{"chain":"A","model":1,"residue":"ALA","number":-3,)"
              R"("insertion":"","atoms":["CA"],"ids":[1],"other_copy":false},"distance":3.142,)"
              R"("angles":{"water":101.3},"offset":null,"donor":"b","waters":[{"chain":"A","model":1,)"
              R"("residue":"ALA","number":-3,"insertion":"","atoms":["CA"],"ids":[1],"other_copy":false}]}])");
    EXPECT_EQ(
        interactionCsv(molecule, found),
        "kind,a_chain,a_model,a_residue,a_number,a_insertion,a_atoms,a_ids,a_other_copy,b_chain,b_model,b_residue,"
        "b_number,b_insertion,b_atoms,b_ids,b_other_copy,distance,angles,offset,donor,waters\n"
        "water-bridge,A,1,LIG,0,B,C1,2,0,A,1,ALA,-3,,CA,1,0,3.142,water=101.3,,b,1\n");
    EXPECT_EQ(interactionText(molecule, found),
              "  interactions\n    water-bridge   3.14 Å  A/LIG 0B C1  -  A/ALA -3 CA  by A/ALA -3 CA\n");
}

TEST(Info, InteractionsOfWhatIsNotThereAreRefused) {
    ContactOptions contacts;
    contacts.of = parseSelection("resn XYZ");
    EXPECT_THROW(listInteractions(twoCarbons(), contacts), Error);
}

TEST(Info, InteractionsBetweenCopiesAreThoseOfAnAssembly) {
    NACRE_NEEDS_DATA();
    const Molecule molecule = readMoleculeFile(test::dataFile("1stp-v5.cif"));
    ContactOptions contacts;
    contacts.of = parseSelection("protein");
    contacts.kinds = {true};  // hydrogen bonds
    const auto isBetween = [](const Interaction& contact) { return contact.a.image || contact.b.image; };
    const auto alone = listInteractions(molecule, contacts), all = listInteractions(molecule, contacts, "1");
    EXPECT_EQ(std::count_if(alone.begin(), alone.end(), isBetween), 0);
    const std::vector<glm::dmat4x3> copies = placeAssembly(molecule, "1").transforms;
    std::size_t between = 0;
    for (const Interaction& contact : all) {
        if (!isBetween(contact)) continue;
        ++between;
        const auto at = [&](const InteractionEnd& end, const glm::dmat4x3& copy) {
            return copy * glm::dvec4(molecule.atoms[end.atoms[0]].position, 1);
        };
        double nearest = 1e9;  // of its length: two copies between which it lies
        for (const glm::dmat4x3& first : copies)
            for (const glm::dmat4x3& second : copies)
                if (&first != &second)
                    nearest = std::min(nearest, std::abs(glm::distance(at(contact.a, first), at(contact.b, second)) -
                                                         contact.distance));
        EXPECT_LT(nearest, 1e-3);
        const std::string text = interactionText(molecule, {contact});
        EXPECT_NE(text.find("of another copy"), std::string::npos) << text;
        const auto json = interactionList(molecule, {contact})[0];
        EXPECT_EQ(json["a"]["other_copy"].get<bool>() + json["b"]["other_copy"].get<bool>(), 1);
    }
    EXPECT_GT(between, 3u);
    EXPECT_EQ(all.size(), alone.size() + between);
    EXPECT_THROW(listInteractions(molecule, contacts, "99"), Error);
}

/// The sample's DNA as two models, in the second of which the strands are apart.
Molecule twoModels() {
    Molecule both = sampleMolecule("dna");
    const Molecule first = both;
    for (Chain chain : first.chains) {
        chain.model = 2;
        both.chains.push_back(chain);
    }
    for (Residue residue : first.residues) {
        residue.chain += static_cast<std::uint32_t>(first.chains.size());
        residue.firstAtom += static_cast<std::uint32_t>(first.atoms.size());
        both.residues.push_back(residue);
    }
    for (Atom atom : first.atoms) {
        if (first.residues[atom.residue].chain == 1) atom.position.x += 50;
        atom.residue += static_cast<std::uint32_t>(first.residues.size());
        both.atoms.push_back(atom);
    }
    const auto shift = static_cast<std::uint32_t>(first.atoms.size());
    for (Bond bond : first.bonds) both.bonds.push_back({bond.a + shift, bond.b + shift, bond.order, bond.source});
    return both;
}

TEST(Info, HowOftenInteractionsAreThere) {
    const Molecule molecule = twoModels();
    ContactOptions contacts{.of = parseSelection("chain A"), .with = parseSelection("chain B"), .kinds = {true}};
    const ContactFrequencies found = contactFrequencies(molecule, contacts, {});
    EXPECT_EQ(found.of, 2u);
    ASSERT_EQ(found.contacts.size(), 32u);
    for (const ContactFrequency& frequency : found.contacts) EXPECT_EQ(frequency.count, 1u);
    const auto list = frequencyList(molecule, found);
    EXPECT_EQ(list[0]["share"], 0.5);
    EXPECT_EQ(list[0]["distance"]["mean"], list[0]["distance"]["min"]);
    EXPECT_TRUE(frequencyCsv(molecule, found)
                    .starts_with("kind,a,b,count,of,percent,mean_distance,min_distance,max_distance\n"
                                 "hydrogen-bond,A/DC 1 O2,B/DG 24 N2,1,2,50.0,3.006,3.006,3.006\n"));
    contacts.with = parseSelection("chain A");  // each strand is whole in both models
    contacts.kinds = {true, true, true, true, true, true, true, true};
    for (const ContactFrequency& frequency : contactFrequencies(molecule, contacts, {}).contacts)
        EXPECT_EQ(frequency.count, 2u);
}

}  // namespace
}  // namespace nacre::app
