// Writes every surface of the catalogue as C++, for expressions_test.cpp: the text that a GPU's compiler
// gets.
#include <fmt/format.h>
#include <isocast/cuda/expression_source.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/expression/simplify.h>

#include <cstdio>
#include <exception>
#include <fstream>

using namespace isocast;

int main(int, char** arguments) try {
  std::ofstream out(arguments[1]);
  out << "#include \"expressions.h\"\n\nnamespace isocast::test {\nnamespace {\n\n";
  std::string table;
  int number = 0;
  for (const CatalogueSurface& surface : catalogue()) {
    out << fmt::format(
        "template <class R> void surface_{}([[maybe_unused]] R x, [[maybe_unused]] R y, [[maybe_unused]] R "
        "z, "
        "[[maybe_unused]] R w, R* registers) {{\n{}}}\n",
        number, expression_body(make_tape(simplify(surface_expression(surface)))));
    table += fmt::format("    {{\"{0}\", surface_{1}, surface_{1}, surface_{1}, surface_{1}}},\n", surface.id,
                         number);
    ++number;
  }
  out << "\n}  // namespace\n\nconst WrittenSurface kWrittenSurfaces[] = {\n"
      << table << "};\nconst int kWrittenCount = " << number << ";\n\n}  // namespace isocast::test\n";
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "write_expressions: %s\n", error.what());
  return 1;
}
