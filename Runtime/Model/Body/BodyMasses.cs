using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Masses of a body and its wings about the body's centre, and the momentum of the wings against it, in body axes.
    /// </summary>
    internal struct BodyMasses
    {
        /// <summary>Σ m x, kg m.</summary>
        public float3 first;

        /// <summary>Inertia about the centre, kg m².</summary>
        public float3x3 inertia;

        /// <summary>Momentum, kg m/s, and angular momentum about the centre, kg m²/s, against the body.</summary>
        public float3 linear, angular;

        /// <summary>Adds a wing as it is at the end of its last substep.</summary>
        public unsafe void Add(in BodyWing wing, in WingPack pack)
        {
            LaneMomentum* momentum = pack.momentum;
            float unit = wing.mass * wing.length, square = unit * wing.length;
            first += wing.ToBody(momentum->first[wing.lane]) * unit;
            linear += wing.ToBody(momentum->linear[wing.lane]) * unit;
            angular += wing.ToBody(momentum->angular[wing.lane]) * (square * wing.handedness);
            float3 squares = momentum->squares[wing.lane] * square, products = momentum->products[wing.lane] * square;
            var own = new float3x3(
                squares.y + squares.z, -products.z, -products.y,
                -products.z, squares.z + squares.x, -products.x,
                -products.y, -products.x, squares.x + squares.y);
            inertia += math.mul(math.mul(wing.axes, own), math.transpose(wing.axes));
        }

        /// <summary>Returns the momentum beyond mass times the centre's velocity, in body axes, kg m/s.</summary>
        /// <param name="spin">Angular velocity, rad/s.</param>
        public readonly float3 Relative(float3 spin) => math.cross(spin, first) + linear;

        /// <summary>Returns the angular momentum about the centre, in body axes, kg m²/s.</summary>
        /// <param name="velocity">Of the centre in body axes, m/s.</param>
        /// <param name="spin">Angular velocity, rad/s.</param>
        public readonly float3 Turning(float3 velocity, float3 spin) =>
            math.cross(first, velocity) + math.mul(inertia, spin) + angular;
    }
}
