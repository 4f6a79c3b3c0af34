// The palettes named in MolViewSpec.

#include "app/mvs/value_palette.h"
#include "engine/molecule/element.h"
#include "engine/molecule/text.h"
#include "engine/scene/color/colors.h"

namespace nacre::app::mvs {
namespace {

struct ColorList {
    std::string_view name, colors;  ///< six digits each
};
constexpr ColorList kLists[] = {
    // ColorBrewer, (c) 2002 Cynthia Brewer, Mark Harrower and The Pennsylvania State University, Apache License 2.0.
    {"Reds", "fff5f0fee0d2fcbba1fc9272fb6a4aef3b2ccb181da50f1567000d"},
    {"Oranges", "fff5ebfee6cefdd0a2fdae6bfd8d3cf16913d94801a636037f2704"},
    {"Greens", "f7fcf5e5f5e0c7e9c0a1d99b74c47641ab5d238b45006d2c00441b"},
    {"Blues", "f7fbffdeebf7c6dbef9ecae16baed64292c62171b508519c08306b"},
    {"Purples", "fcfbfdefedf5dadaebbcbddc9e9ac8807dba6a51a354278f3f007d"},
    {"Greys", "fffffff0f0f0d9d9d9bdbdbd969696737373525252252525000000"},
    {"OrRd", "fff7ecfee8c8fdd49efdbb84fc8d59ef6548d7301fb300007f0000"},
    {"BuGn", "f7fcfde5f5f9ccece699d8c966c2a441ae76238b45006d2c00441b"},
    {"PuBuGn", "fff7fbece2f0d0d1e6a6bddb67a9cf3690c002818a016c59014636"},
    {"GnBu", "f7fcf0e0f3dbccebc5a8ddb57bccc44eb3d32b8cbe0868ac084081"},
    {"PuBu", "fff7fbece7f2d0d1e6a6bddb74a9cf3690c00570b0045a8d023858"},
    {"BuPu", "f7fcfde0ecf4bfd3e69ebcda8c96c68c6bb188419d810f7c4d004b"},
    {"RdPu", "fff7f3fde0ddfcc5c0fa9fb5f768a1dd3497ae017e7a017749006a"},
    {"PuRd", "f7f4f9e7e1efd4b9dac994c7df65b0e7298ace125698004367001f"},
    {"YlOrRd", "ffffccffeda0fed976feb24cfd8d3cfc4e2ae31a1cbd0026800026"},
    {"YlOrBr", "ffffe5fff7bcfee391fec44ffe9929ec7014cc4c02993404662506"},
    {"YlGn", "ffffe5f7fcb9d9f0a3addd8e78c67941ab5d238443006837004529"},
    {"YlGnBu", "ffffd9edf8b1c7e9b47fcdbb41b6c41d91c0225ea8253494081d58"},
    {"RdBu", "67001fb2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac053061"},
    {"RdGy", "67001fb2182bd6604df4a582fddbc7ffffffe0e0e0bababa8787874d4d4d1a1a1a"},
    {"PiYG", "8e0152c51b7dde77aef1b6dafde0eff7f7f7e6f5d0b8e1867fbc414d9221276419"},
    {"BrBG", "5430058c510abf812ddfc27df6e8c3f5f5f5c7eae580cdc135978f01665e003c30"},
    {"PRGn", "40004b762a839970abc2a5cfe7d4e8f7f7f7d9f0d3a6dba05aae611b783700441b"},
    {"PuOr", "2d004b5427888073acb2abd2d8daebf7f7f7fee0b6fdb863e08214b358067f3b08"},
    {"RdYlGn", "a50026d73027f46d43fdae61fee08bffffbfd9ef8ba6d96a66bd631a9850006837"},
    {"RdYlBu", "a50026d73027f46d43fdae61fee090ffffbfe0f3f8abd9e974add14575b4313695"},
    {"Spectral", "9e0142d53e4ff46d43fdae61fee08bffffbfe6f598abdda466c2a53288bd5e4fa2"},
    {"Set1", "e41a1c377eb84daf4a984ea3ff7f00ffff33a65628f781bf999999"},
    {"Set2", "66c2a5fc8d628da0cbe78ac3a6d854ffd92fe5c494b3b3b3"},
    {"Set3", "8dd3c7ffffb3bebadafb807280b1d3fdb462b3de69fccde5d9d9d9bc80bdccebc5ffed6f"},
    {"Pastel1", "fbb4aeb3cde3ccebc5decbe4fed9a6ffffcce5d8bdfddaecf2f2f2"},
    {"Pastel2", "b3e2cdfdcdaccbd5e8f4cae4e6f5c9fff2aef1e2cccccccc"},
    {"Dark2", "1b9e77d95f027570b3e7298a66a61ee6ab02a6761d666666"},
    {"Paired", "a6cee31f78b4b2df8a33a02cfb9a99e31a1cfdbf6fff7f00cab2d66a3d9affff99b15928"},
    {"Accent", "7fc97fbeaed4fdc086ffff99386cb0f0027fbf5b17666666"},
    // Matplotlib: S. van der Walt, N. Smith and E. Firing, CC0. Cividis: J. Nunez, C. Anderton and R. Renslow.
    {"Magma",
     "00000402020b0504160907200e0b2b140e361a104221114d29115a3310673b0f70440f764c117a54137d5b157f641a80"
     "6b1d817521817c23828426818c2981942c809c2e7fa5317ead347cb73779bf3a77c73d73ce3f70d6456bde4968e44f64"
     "ea5661ef5d5ef4675cf7705cf9795dfb835ffc8c63fd9668fe9f6dfea973feb47bfebd82fec68afecf92fed89afde2a3"
     "fdebacfcf4b6fcfdbf"},
    {"Inferno",
     "00000402020c0504170a072210092d160b391e0c45250c512f0a5b390963420a684a0c6b520e6d5a116e62136e6a176e"
     "721a6e7c1d6d84206b8c23699326679b2964a32c61ab2f5eb3325abc3754c33b4fca404acf4445d74b3edd513ae25734"
     "e75e2eeb6628f06f20f37819f68013f8890cfa9207fb9b06fca50afcae12fbba1ffac42af8cd37f6d746f4e156f2ea69"
     "f2f27df5f992fcffa4"},
    {"Plasma",
     "1b068c2505912f049538049940039c49029f5101a25901a46100a66800a77000a87801a87f03a78607a68e0ca49511a1"
     "9b179ea21c9aa82296ae2791b42d8db93388be3883c33e7fc8447acd4975d14f71d6556dda5a68de6064e26660e56c5b"
     "e97257ec7853ef7e4ef2854af58b46f79241f9993dfaa039fca735fdaf31fdb62dfdbe29fdc626fcce25fad624f8df24"
     "f5e726f2f026eff821"},
    {"Viridis",
     "45085b470f62471669481d6f482374472a7946307d453681433c844142863e48883c4d8a3a538b37588c355d8c32628d"
     "30678d2e6c8e2c718e2a768e287a8e267f8e24848d23898d218d8c1f928c1e978a1e9b891ea08720a58523a98228ae7f"
     "2eb27c35b7783dbb7445bf6f4fc36959c76464cb5d70ce567cd24f88d54795d73fa2da37afdc2ebdde26cae01ed7e219"
     "e4e318f1e51cfde724"},
    {"Cividis",
     "00205100245900275f012b64052e680a326a10366c15396d1d3d6e24406e2b446e32486e394b6e404f6e45526d4d566d"
     "535a6e595e6e5e616e64656f6969706e6c717270727774737b78747f7c75837f768883778c8677908b78948f78999378"
     "9d9778a29b78a7a077ada476b2a874b8ac72beb170c4b56dcaba6ad1be66d7c363dec85fe4cc5aead156efd652f4db4e"
     "f8e04bfbe548fdea45"},
    // Turbo: A. Mikhailov. The last palette lacks its black. The others by the formulas of D3.
    {"Turbo",
     "23171b362356422f85493caa4b4ac74a58dd4666eb4174f43b82f83590f82f9df52aaaef27b6e625c2dc25ccd027d7c4"
     "2be0b731e8aa38ee9d42f4904df88459fb7867fd6d76fe6385fd5995fb51a4f749b4f242c2ec3cd1e436dedd32ead32e"
     "f4c92bfcbd28ffb125ffa423ff9721ff891eff7b1cfd6d1af65f18ec5115e14412d5370fc72c0cba2208ad1905a21202"
     "980e00920c00900c00"},
    {"Chainbow",
     "4a41b54a58dd426ff23987f92f9df528b2e925c6d827d7c42ee5ae3bf0984df88462fd707bfe5f95fb51aff444c8ea3a"
     "dedd32f0cc2cfeb927ffa423ff8e1fff761cf65f18e54813d0330eba2208a51403960d00"},
    {"Warm",
     "6e40aa753fad7d3faf863eb18e3eb2963db39e3db3a73cb3af3cb2b73cb1bf3cafc73daccf3da9d63ea6dc3fa2e4419d"
     "ea4299f04494f5468efa4988fe4b83ff4e7cff5276ff5670ff5a6aff5e63ff635dff6757ff6c51ff724bff7847ff7d42"
     "ff833dff8a39ff9036fb9633f69d31f2a42fedaa2ee7b12ee2b72fdcbe30d7c432d1ca34ccd038c6d63cc1dc41bce146"
     "b7e64cb3eb53aff05b"},
    {"Cool",
     "6e40aa6c43b16947b7674bbd6450c36054c85d59cd595ed15563d55169d94c6edb4874de437ae03f80e13a85e1368ce1"
     "3292e12e98df2a9fde27a5db23abd821b1d51eb7d11cbccc1bc2c71ac7c219cdbc19d1b61ad5b01bdbaa1ddfa320e29c"
     "23e69627e98f2bec8930ef8236f17c3cf27643f4714af56c52f6675af66363f75f6cf65c75f65a7ff65888f55792f457"
     "9cf357a6f159aff05b"},
    {"CubehelixDefault",
     "0000000803080f0612140a1c180f261a15301b1c391a2241192b4717344b163d4e15464e154f4d17574a195e461f6642"
     "266c3c2f713739753346783054792f637a2f737b32827a37927a3fa07949ad7955b97963c27a71ca7c82d07e93d382a3"
     "d487b3d48dc1d294cecf9cdacca5e3c9aeeac5b8efc3c1f2c1caf3c2d3f3c3dbf2c7e2f1cce8f0d2eeefdaf2efe3f6f0"
     "ecf9f3f6fcf8ffffff"},
    {"Rainbow",
     "6e40aa7d3faf8e3eb29e3db3af3cb2bf3cafcf3da9dc3fa2ea4299f5468efe4b83ff5276ff5a6aff635dff6c51ff7847"
     "ff833dff9036f69d31edaa2ee2b72fd7c432ccd038c1dc41b7e64caff05b9cf35788f55775f65962f75f52f66743f471"
     "36f17c2bec8923e6961ddfa31ad6b019cdbc1bc2c71eb7d123abd82a9fde3292e13a86e1437ae04c6edb5563d55d59cd"
     "6450c36947b76e40aa"},
    {"Sinebow",
     "ff4040fe4e32fb5d26f66d1cef7d12e78d0bdc9d05d1ab02c4bb00b6c800a7d50397e00788ea0d77f21568f81e58fc2a"
     "49ff373bff442efd5323fa6218f47210ed8209e39204d9a201cdb100bfbf01b1cd04a2d90892e21081ed1872f42362fa"
     "2e53fd3b44ff4937ff582afc681ff87715f2880dea9707e0a703d5b600c8c400bbd102acdc059de70b8def127df61c6d"
     "fb265dfe324eff4040"},
    // D3, Observable and Tableau.
    {"Category10", "1f77b4ff7f0e2ca02cd627289467bd8c564be377c27f7f7fbcbd2217becf"},
    {"Observable10", "4269d0efb118ff725c6cc5b03ca951ff8ab7a463f297bbf59c6b4e9498a0"},
    {"Tableau10", "4e79a7f28e2ce1575976b7b259a14fedc949af7aa1ff9da79c755fbab0ab"},
};

struct NamedColor {
    std::string_view name;
    std::uint32_t rgb;
};
// Amino acids as Clustal colours them.
constexpr NamedColor kAminoAcids[] = {{"HIS", 0x15a4a4}, {"TYR", 0x15a4a4}, {"ALA", 0x80a0f0}, {"VAL", 0x80a0f0},
                                      {"LEU", 0x80a0f0}, {"ILE", 0x80a0f0}, {"MET", 0x80a0f0}, {"PHE", 0x80a0f0},
                                      {"TRP", 0x80a0f0}, {"SER", 0x15c015}, {"THR", 0x15c015}, {"ASN", 0x15c015},
                                      {"GLN", 0x15c015}, {"LYS", 0xf01505}, {"ARG", 0xf01505}, {"ASP", 0xc048c0},
                                      {"GLU", 0xc048c0}, {"PRO", 0xc0c000}, {"CYS", 0xf08080}, {"GLY", 0xf09048}};
constexpr std::string_view kNucleotides[] = {"A", "C", "G", "I", "T", "U", "DA", "DC", "DG", "DI", "DT", "DU"};
// As Jmol colours them; it has no colour for the left-handed helix P.
constexpr NamedColor kSecondary[] = {{"helix", 0xff0080}, {"strand", 0xffc800}, {"turn", 0x6080ff}, {"bend", 0x66d8c9},
                                     {"H", 0xff0080},     {"B", 0xffc800},      {"E", 0xffc800},    {"G", 0xa00080},
                                     {"I", 0x600080},     {"P", 0xa00000},      {"T", 0x6080ff},    {"S", 0x66d8c9}};

constexpr int kLastElement = 118;

std::uint32_t digit(char c) { return static_cast<std::uint32_t>(c <= '9' ? c - '0' : c - 'a' + 10); }

}  // namespace

std::vector<std::uint32_t> namedColorList(std::string_view name) {
    std::vector<std::uint32_t> colors;
    for (const ColorList& list : kLists) {
        if (list.name != name) continue;
        for (std::size_t i = 0; i < list.colors.size(); i += 6) {
            std::uint32_t rgb = 0;
            for (const char c : list.colors.substr(i, 6)) rgb = 16 * rgb + digit(c);
            colors.push_back(packedColor(rgb));
        }
    }
    return colors;
}

std::vector<std::uint32_t> molstarColorList(std::string_view name) {
    constexpr std::pair<std::string_view, std::string_view> kNames[] = {{"orange-red", "OrRd"},
                                                                        {"blue-green", "BuGn"},
                                                                        {"purple-blue-green", "PuBuGn"},
                                                                        {"green-blue", "GnBu"},
                                                                        {"purple-blue", "PuBu"},
                                                                        {"blue-purple", "BuPu"},
                                                                        {"red-purple", "RdPu"},
                                                                        {"purple-red", "PuRd"},
                                                                        {"yellow-orange-red", "YlOrRd"},
                                                                        {"yellow-orange-brown", "YlOrBr"},
                                                                        {"yellow-green", "YlGn"},
                                                                        {"yellow-green-blue", "YlGnBu"},
                                                                        {"red-blue", "RdBu"},
                                                                        {"red-grey", "RdGy"},
                                                                        {"pink-yellow-green", "PiYG"},
                                                                        {"brown-white-green", "BrBG"},
                                                                        {"purple-green", "PRGn"},
                                                                        {"purple-orange", "PuOr"},
                                                                        {"red-yellow-green", "RdYlGn"},
                                                                        {"red-yellow-blue", "RdYlBu"},
                                                                        {"turbo-no-black", "Chainbow"}};
    for (const auto& [own, named] : kNames)
        if (own == name) return namedColorList(named);
    // "set-1", "viridis"
    std::string plain(name);
    std::erase(plain, '-');
    for (const ColorList& list : kLists)
        if (lowerCase(list.name) == lowerCase(plain)) return namedColorList(list.name);
    return {};
}

std::map<std::string, std::uint32_t> namedColorMap(std::string_view name) {
    std::map<std::string, std::uint32_t> colors;
    if (name == "ElementSymbol") {
        for (int i = 1; i <= kLastElement; ++i) {
            const std::string symbol(elementSymbol(static_cast<Element>(i)));
            if (symbol == "C") continue;  // keeps the colours below
            for (const std::string& spelling : {symbol, upperCase(symbol)})
                colors.emplace(spelling, elementColor(static_cast<Element>(i)));
        }
    }
    if (name == "ResidueName" || name == "ResidueProperties") {
        for (const NamedColor& each : kAminoAcids)
            colors.emplace(each.name, name == "ResidueName" ? residueColor(each.name) : packedColor(each.rgb));
        for (const std::string_view each : kNucleotides) colors.emplace(each, residueColor(each));
    }
    if (name == "SecondaryStructure")
        for (const NamedColor& each : kSecondary) colors.emplace(each.name, packedColor(each.rgb));
    return colors;
}

}  // namespace nacre::app::mvs
