// SPDX-License-Identifier: AGPL-3.0-or-later
// Fills a closed surface with tets: stdin to stdout, see exchange.hpp. TetGen ends the process,
// crashes or hangs on some inputs; whoever starts this program expects that. Switches: p (PLC), Y
// (keep the surface), q1.414 (radius-edge ratio), Q (quiet).
#include <cstdio>
#include <vector>

#include <tetgen.h>

#include "ops/mesher/jobs.hpp"
#include "ops/mesher/tets_exchange.hpp"

namespace {

using tedit::ops::exchange_header;

template <class T>
bool read_all(std::vector<T>& values, std::size_t count) {
  values.resize(count);
  return count == 0 || std::fread(values.data(), sizeof(T), count, stdin) == count;
}

void set_facets(tetgenio& in, const std::vector<std::uint32_t>& triangles) {
  in.numberoffacets = static_cast<int>(triangles.size() / 3);
  in.facetlist = new tetgenio::facet[in.numberoffacets];
  for (int f = 0; f < in.numberoffacets; ++f) {
    auto& facet = in.facetlist[f];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1];
    tetgenio::init(facet.polygonlist);
    facet.polygonlist[0].numberofvertices = 3;
    facet.polygonlist[0].vertexlist = new int[3];
    for (int i = 0; i < 3; ++i)
      facet.polygonlist[0].vertexlist[i] = static_cast<int>(triangles[3 * f + i]);
  }
}

}  // namespace

int tedit::ops::fill_with_tets(std::uint32_t magic) {
  exchange_header header;
  constexpr std::uint32_t most = 10'000'000;
  if (!read_rest(header, magic) || header.points > most || header.cells > most ||
      !end_after(header.most_ms))
    return 2;
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
  if (!read_all(points, 3ul * header.points) || !read_all(triangles, 3ul * header.cells))
    return 2;
  for (const auto index : triangles)
    if (index >= header.points)
      return 2;
  tetgenio in;
  tetgenio out;
  in.numberofpoints = static_cast<int>(header.points);
  in.pointlist = new REAL[points.size()];
  std::copy(points.begin(), points.end(), in.pointlist);
  set_facets(in, triangles);
  char switches[] = "pYq1.414Q";
  tetrahedralize(switches, &in, &out);
  if (out.numberoftetrahedra <= 0 || out.numberofcorners != 4)
    return 3;
  header.most_ms = 0;
  header.points = static_cast<std::uint32_t>(out.numberofpoints);
  header.cells = static_cast<std::uint32_t>(out.numberoftetrahedra);
  const std::size_t reals = 3ul * header.points;
  const std::size_t corners = 4ul * header.cells;
  const bool ok = std::fwrite(&header, sizeof(header), 1, stdout) == 1 &&
                  std::fwrite(out.pointlist, sizeof(REAL), reals, stdout) == reals &&
                  std::fwrite(out.tetrahedronlist, sizeof(int), corners, stdout) == corners &&
                  std::fflush(stdout) == 0;
  return ok ? 0 : 4;
}
