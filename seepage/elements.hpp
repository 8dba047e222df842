#pragma once

// The conductance matrix of an element, by bilinear or linear shape functions N,
//
//     K_ij = int k k_r(h - y) grad N_i . grad N_j dA,
//
// which gives the water that flows through its nodes, q = K h. Quadrilaterals take 2 x 2 Gauss points in each
// of their quarters, triangles the middles of their edges; k_r is that of each point. Points as dense as that
// let k_r fall over a quarter of a cell: with 2 x 2 points alone, those that cross the surface go on
// switching.

#include "seepage/flow_problem.hpp"

#include <Eigen/Core>

#include <span>

namespace tremolo::seepage {

/// k_r of ground whose pressure head is psi (m): 1 below the phreatic surface and 1e-3 above it, linear over
/// `transition` (m) of suction.
double relative_permeability(double psi, double transition);

/// K of an element with k_r = 1, m/s, by its corners; rows and columns beyond them are zero.
Eigen::Matrix4d full_conductance(const FlowProblem& problem, const Element& element);

/// K under the heads of all nodes (m).
/// @param full  that of full_conductance()
Eigen::Matrix4d conductance(const FlowProblem& problem, const Element& element, const Eigen::Matrix4d& full,
                            std::span<const double> heads);

/// grad h at the centre of an element, 1
Vector gradient(const FlowProblem& problem, const Element& element, std::span<const double> heads);

/// m2
double area(const FlowProblem& problem, const Element& element);

} // namespace tremolo::seepage
