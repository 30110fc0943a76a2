using System;

namespace Alate.Tests
{
    /// <summary>Quaternion in double precision, so that expected rotations are computed apart from Unity's and the package's own.</summary>
    internal readonly struct Rotation
    {
        public readonly double w, x, y, z;

        public Rotation(double w, double x, double y, double z)
        {
            this.w = w;
            this.x = x;
            this.y = y;
            this.z = z;
        }

        /// <summary>Conjugate: the rotation back.</summary>
        public Rotation Back => new Rotation(w, -x, -y, -z);

        public double Length => Math.Sqrt(w * w + x * x + y * y + z * z);

        /// <summary>Rotation about a unit axis.</summary>
        public static Rotation About(double x, double y, double z, double degrees)
        {
            double half = degrees * Math.PI / 360.0, sin = Math.Sin(half);
            return new Rotation(Math.Cos(half), sin * x, sin * y, sin * z);
        }

        /// <summary>Vector as a quaternion without a real part.</summary>
        public static Rotation Vector(double x, double y, double z) => new Rotation(0.0, x, y, z);

        /// <summary>Hamilton's product: first b, then a.</summary>
        public static Rotation operator *(Rotation a, Rotation b) => new Rotation(
            a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w);

        public static Rotation operator *(double a, Rotation b) => new Rotation(a * b.w, a * b.x, a * b.y, a * b.z);

        public static Rotation operator +(Rotation a, Rotation b) => new Rotation(a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z);
    }
}
