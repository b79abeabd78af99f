// Gauss-Legendre quadrature.
#pragma once

#include <array>
#include <cstddef>

namespace flexslip {

template <std::size_t size>
struct GaussRule {
  std::array<double, size> node;  // in [-1, 1]
  std::array<double, size> weight;
};

// The error over an interval h of a function that varies as exp(i x/l) is, relative to it, below 5e-7 (h/l)^6, 2e-16 (h/l)^12
// and 6e-31 (h/l)^20.
inline constexpr GaussRule<3> gauss_3{{-0.77459666924148338, 0.0, 0.77459666924148338},
                                      {0.55555555555555556, 0.88888888888888889, 0.55555555555555556}};
inline constexpr GaussRule<6> gauss_6{{-0.93246951420315203, -0.66120938646626451, -0.23861918608319691,
                                       0.23861918608319691, 0.66120938646626451, 0.93246951420315203},
                                      {0.17132449237917035, 0.36076157304813861, 0.46791393457269105,
                                       0.46791393457269105, 0.36076157304813861, 0.17132449237917035}};
inline constexpr GaussRule<10> gauss_10{
    {-0.97390652851717172, -0.86506336668898451, -0.67940956829902441, -0.43339539412924719, -0.14887433898163122,
     0.14887433898163122, 0.43339539412924719, 0.67940956829902441, 0.86506336668898451, 0.97390652851717172},
    {0.06667134430868814, 0.14945134915058059, 0.21908636251598204, 0.26926671930999636, 0.29552422471475287,
     0.29552422471475287, 0.26926671930999636, 0.21908636251598204, 0.14945134915058059, 0.06667134430868814}};
inline constexpr GaussRule<12> gauss_12{
    {-0.98156063424671925, -0.90411725637047486, -0.76990267419430469, -0.58731795428661745, -0.36783149899818019,
     -0.12523340851146892, 0.12523340851146892, 0.36783149899818019, 0.58731795428661745, 0.76990267419430469,
     0.90411725637047486, 0.98156063424671925},
    {0.047175336386511827, 0.10693932599531843, 0.16007832854334623, 0.20316742672306592, 0.23349253653835481,
     0.24914704581340279, 0.24914704581340279, 0.23349253653835481, 0.20316742672306592, 0.16007832854334623,
     0.10693932599531843, 0.047175336386511827}};

// Σ weight f(x) over [a, b]; f returns something that can be scaled and added.
template <std::size_t size, class Function>
auto integral(const GaussRule<size>& rule, double a, double b, Function f) {
  const double middle = 0.5 * (a + b);
  const double reach = 0.5 * (b - a);
  decltype(f(a)) sum{};
  for (std::size_t i = 0; i < size; ++i) sum += reach * rule.weight[i] * f(middle + reach * rule.node[i]);
  return sum;
}

}  // namespace flexslip
