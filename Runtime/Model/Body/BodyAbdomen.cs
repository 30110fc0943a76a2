using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Abdomen that swings up and down about a hinge behind the thorax, once a beat; its inertia moves the rest of the body. The default
    /// value is none: an abdomen that does not swing belongs to the body.
    /// </summary>
    internal struct BodyAbdomen
    {
        /// <summary>Mass, kilograms; 0 for none.</summary>
        public float mass;

        /// <summary>Hinge from the body's centre, and from there to the abdomen's own centre where it does not swing, metres.</summary>
        public float3 hinge, arm;

        /// <summary>Inertia about its own centre where it does not swing, kg m².</summary>
        public float3x3 inertia;

        /// <summary>Half of the swing, radians, and the phase of the beat in which the abdomen hangs lowest, radians.</summary>
        public float amplitude, lowest;

        /// <summary>Evaluates the angle above where it does not swing, radians; turns about X by it.</summary>
        /// <param name="amplitude">Half of the swing, radians.</param>
        /// <param name="lowest">Phase in which it hangs lowest, radians.</param>
        /// <param name="phase">Φ of the beat, radians.</param>
        public static float AngleAt(float amplitude, float lowest, float phase) => -amplitude * Elementary.Cos(phase - lowest);

        /// <summary>Adds the abdomen to the masses of the body.</summary>
        /// <param name="masses">Masses of the body without it, in body axes about its centre.</param>
        /// <param name="phase">Φ of the beat, radians.</param>
        /// <param name="rate">Of the phase, rad/s.</param>
        public readonly void AddTo(ref BodyMasses masses, float phase, float rate)
        {
            if (mass == 0f)
                return;
            quaternion turn = Rotations.AboutX(AngleAt(amplitude, lowest, phase));
            var spin = new float3(amplitude * rate * Elementary.Sin(phase - lowest), 0f, 0f);
            float3 reach = math.rotate(turn, arm), at = hinge + reach, velocity = math.cross(spin, reach);
            var axes = new float3x3(turn);
            float3x3 own = math.mul(math.mul(axes, inertia), math.transpose(axes));
            masses.first += mass * at;
            masses.linear += mass * velocity;
            masses.angular += mass * math.cross(at, velocity) + math.mul(own, spin);
            masses.inertia += own + mass * (float3x3.Scale(math.dot(at, at)) - Outer(at));
        }

        private static float3x3 Outer(float3 v) => new float3x3(v * v.x, v * v.y, v * v.z);
    }
}
