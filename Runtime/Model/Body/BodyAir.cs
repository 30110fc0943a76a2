using Unity.Mathematics;

namespace Alate
{
    /// <summary>Force and moment of the air on a body, through its wings and on its own hull, in one substep and in body axes.</summary>
    internal struct BodyAir
    {
        /// <summary>Force, N, and moment about the centre of mass, N m, of the wings.</summary>
        public float3 force, moment;

        /// <summary>Power that the wings give to the air, W.</summary>
        public float power;

        /// <summary>K of all wings.</summary>
        public Symmetric6 damping;

        /// <summary>Writes what a wing meets into its lanes.</summary>
        public static unsafe void Surround(in FlyingBody body, in BodyWing wing, in WingPack pack)
        {
            float3x3 toBody = math.transpose(new float3x3(body.middleRotation));
            float inverse = 1f / wing.length;
            var around = new WingSurroundings
            {
                wind = wing.ToWing(math.mul(toBody, body.wind - body.middleVelocity)) * inverse,
                angularVelocity = wing.ToWing(body.middleSpin) * wing.handedness,
                hinge = wing.ToWing(wing.hinge) * inverse,
                gravity = wing.ToWing(math.mul(toBody, body.gravity)) * (inverse * wing.gravityShare),
            };
            pack.surroundings->Set(wing.lane, around);
            for (int lane = wing.firstCopy; lane < wing.endCopy; lane++)
                pack.surroundings->Set(lane, around);
        }

        /// <summary>Adds the air of a wing.</summary>
        public unsafe void Add(in BodyWing wing, in WingPack pack)
        {
            LaneAir* air = pack.air;
            float unit = wing.mass * wing.length;
            force += wing.ToBody(air->force[wing.lane]) * unit;
            power += air->power[wing.lane] * (unit * wing.length);
            moment += wing.ToBody(air->moment[wing.lane]) * (unit * wing.length * wing.handedness);

            // Blocks of velocity and of turning carry over with the frame's axes, those between them with its handedness.
            float mass = wing.mass, arm = unit * wing.handedness, turn = unit * wing.length;
            float3x3 back = math.transpose(wing.axes);
            damping.uu += math.mul(math.mul(wing.axes, Block(air->uu, wing.lane, mass)), back);
            damping.uw += math.mul(math.mul(wing.axes, Block(air->uw, wing.lane, arm)), back);
            damping.ww += math.mul(math.mul(wing.axes, Block(air->ww, wing.lane, turn)), back);
        }

        private static float3x3 Block(in SoaFloat3x3 all, int lane, float unit) =>
            new float3x3(all.c0[lane] * unit, all.c1[lane] * unit, all.c2[lane] * unit);
    }
}
