using System;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>A vector in double precision.</summary>
    internal readonly record struct Vector(double X, double Y, double Z)
    {
        public Vector(float3 v, double factor = 1.0)
            : this(v.x * factor, v.y * factor, v.z * factor)
        {
        }

        public double Length => Math.Sqrt(X * X + Y * Y + Z * Z);

        public static Vector operator +(Vector a, Vector b) => new Vector(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        public static Vector operator -(Vector a, Vector b) => new Vector(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        public static Vector operator *(double factor, Vector a) => new Vector(factor * a.X, factor * a.Y, factor * a.Z);

        public static Vector Cross(Vector a, Vector b) => new Vector(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

        /// <summary>A vector turned by a rotation.</summary>
        public static Vector Rotate(quaternion rotation, Vector v)
        {
            var axis = new Vector(rotation.value.xyz);
            double w = rotation.value.w;
            Vector t = 2.0 * Cross(axis, v);
            return v + w * t + Cross(axis, t);
        }

        /// <summary>A vector of a frame with these directions.</summary>
        public static Vector Transform(float3x3 axes, Vector v) =>
            v.X * new Vector(axes.c0) + v.Y * new Vector(axes.c1) + v.Z * new Vector(axes.c2);
    }
}
