#pragma once

namespace tremolo {

/// A vector in the plane: x to the right, y up.
struct Vector {
  double x = 0.0;
  double y = 0.0;
};

inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y};
}
inline Vector operator-(const Vector& a) {
  return {-a.x, -a.y};
}
inline Vector operator*(double factor, const Vector& a) {
  return {factor * a.x, factor * a.y};
}
inline Vector operator/(const Vector& a, double divisor) {
  return {a.x / divisor, a.y / divisor};
}
inline Vector& operator+=(Vector& a, const Vector& b) {
  return a = a + b;
}

inline double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y;
}

/// a . a
inline double square(const Vector& a) {
  return dot(a, a);
}

/// The out-of-plane component of a x b.
inline double cross(const Vector& a, const Vector& b) {
  return a.x * b.y - a.y * b.x;
}

} // namespace tremolo
