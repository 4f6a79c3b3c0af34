#include "engine/molecule/assemblies.h"

#include <cmath>

#include "engine/molecule/text.h"

namespace nacre {

namespace {

[[noreturn]] void malformed(std::string_view expression) {
    throw AssemblyFault("its operator expression is malformed: '" + printable(expression) + "'");
}

using Factor = std::vector<const TransformsById::value_type*>;

/// A file may repeat a long name a million times.
std::string cutName(const std::string& name) { return name.substr(0, 200); }

class ExpressionReader {
public:
    ExpressionReader(std::string_view expression, const TransformsById& operators, AssemblyLimits& limits)
        : expression_(expression), operators_(operators), limits_(limits) {}

    /// Factors of the product, at least one, none empty.
    std::vector<Factor> read() {
        std::vector<Factor> factors;
        std::string_view rest = trim(expression_);
        if (rest.find('(') == std::string_view::npos) return {list(rest)};
        while (!rest.empty()) {
            const std::size_t end = rest.find(')');
            if (rest.front() != '(' || end == std::string_view::npos) malformed(expression_);
            factors.push_back(list(rest.substr(1, end - 1)));
            rest = trim(rest.substr(end + 1));
        }
        return factors;
    }

private:
    Factor list(std::string_view text) {
        Factor factor;
        for (;;) {
            const std::size_t comma = text.find(',');
            item(trim(text.substr(0, comma)), factor);
            if (comma == std::string_view::npos) return factor;
            text.remove_prefix(comma + 1);
        }
    }

    void item(std::string_view text, Factor& factor) {
        const std::size_t dash = text.find('-');
        if (dash == std::string_view::npos || operators_.find(text) != operators_.end()) {
            add(text, factor);
            return;
        }
        const auto first = parseInteger(text.substr(0, dash)), last = parseInteger(text.substr(dash + 1));
        if (!first || !last || *first < 0 || *last < *first) malformed(expression_);
        for (std::int64_t id = *first; id <= *last; ++id) add(std::to_string(id), factor);
    }

    void add(std::string_view id, Factor& factor) {
        const auto found = operators_.find(id);
        if (found == operators_.end()) throw AssemblyFault("it has no operator '" + printable(id) + "'");
        limits_.spend(1, 0);
        factor.push_back(&*found);
    }

    std::string_view expression_;
    const TransformsById& operators_;
    AssemblyLimits& limits_;
};

}  // namespace

TransformRows multiply(const TransformRows& first, const TransformRows& second) {
    TransformRows product{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            double sum = column == 3 ? first[row * 4 + 3] : 0;
            for (std::size_t k = 0; k < 3; ++k) sum += first[row * 4 + k] * second[k * 4 + column];
            product[row * 4 + column] = sum;
        }
    return product;
}

glm::mat4x3 toMatrix(const TransformRows& rows) {
    glm::mat4x3 matrix(0.0f);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!(std::abs(rows[i]) <= 1e9)) throw AssemblyFault("a number of its transforms is missing or too large");
        matrix[static_cast<int>(i % 4)][static_cast<int>(i / 4)] = static_cast<float>(rows[i]);
    }
    return matrix;
}

void AssemblyLimits::spend(std::size_t transforms, std::size_t subchains) {
    if (transforms > transforms_ || subchains > subchains_)
        throw AssemblyFault("the assemblies have more than " + std::to_string(maxTransforms_) + " transforms or " +
                            std::to_string(kMaxSubchains) + " chains");
    transforms_ -= transforms;
    subchains_ -= subchains;
}

AssemblyPart expandOperators(std::string_view expression, const TransformsById& operators, AssemblyLimits& limits) {
    const std::vector<Factor> factors = ExpressionReader(expression, operators, limits).read();
    std::vector<std::pair<std::string, TransformRows>> products;
    for (const auto* one : factors.back()) products.emplace_back(cutName(one->first), one->second);
    for (std::size_t i = factors.size() - 1; i-- > 0;) {
        // Both sizes are below the limit, so that their product is far from overflow.
        limits.spend(factors[i].size() * products.size(), 0);
        decltype(products) next;
        next.reserve(factors[i].size() * products.size());
        for (const auto* left : factors[i])
            for (const auto& [name, right] : products)
                next.emplace_back(cutName(cutName(left->first) + "-" + name), multiply(left->second, right));
        products = std::move(next);
    }
    AssemblyPart part;
    part.transforms.reserve(products.size()), part.operators.reserve(products.size());
    for (auto& [name, product] : products) {
        part.transforms.push_back(toMatrix(product));
        part.operators.push_back(std::move(name));
    }
    return part;
}

void addPart(Assembly& assembly, AssemblyPart part) {
    if (part.transforms.empty() || part.subchains.empty()) return;
    std::ranges::sort(part.subchains);
    part.subchains.erase(std::unique(part.subchains.begin(), part.subchains.end()), part.subchains.end());
    if (assembly.parts.empty() || assembly.parts.back().subchains != part.subchains) {
        assembly.parts.push_back(std::move(part));
        return;
    }
    AssemblyPart& all = assembly.parts.back();
    std::ranges::copy(part.transforms, std::back_inserter(all.transforms));
    std::ranges::move(part.operators, std::back_inserter(all.operators));
}

std::string leftOutWarning(std::string_view id, const std::string& why) {
    return "assembly " + printable(id) + " is left out: " + why;
}

std::string findLeftOutWarning(const Molecule& molecule, std::string_view id) {
    const std::string begin = "assembly " + (id.empty() ? std::string() : printable(id) + " is left out: ");
    for (const std::string& warning : molecule.warnings)
        if (warning.starts_with(begin)) return warning;
    return {};
}

std::vector<Assembly> assembliesFor(const Molecule& to, const Molecule& from) {
    std::map<std::string, std::uint32_t> places;
    for (std::uint32_t i = 0; i < to.subchains.size(); ++i) places.emplace(to.subchains[i], i);
    std::vector<Assembly> assemblies = from.assemblies;
    for (Assembly& assembly : assemblies)
        for (AssemblyPart& part : assembly.parts) {
            std::vector<std::uint32_t> subchains;
            for (const std::uint32_t i : part.subchains)
                if (const auto found = places.find(from.subchains[i]); found != places.end())
                    subchains.push_back(found->second);
            std::sort(subchains.begin(), subchains.end());
            part.subchains = std::move(subchains);
        }
    return assemblies;
}

}  // namespace nacre
