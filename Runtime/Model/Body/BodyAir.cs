using Unity.Mathematics;

namespace Alate
{
    /// <summary>What the air does to a body through its wings and upon its own hull in one substep, in body axes.</summary>
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

            // K in the wing's frame: blocks of velocity and of turning carry over with the frame's axes, those of turning with its handedness.
            float3x3 uu = Block(air, wing.lane, 0, 0), uw = Block(air, wing.lane, 0, 3), ww = Block(air, wing.lane, 3, 3);
            float3x3 back = math.transpose(wing.axes);
            uu = math.mul(math.mul(wing.axes, uu), back);
            uw = math.mul(math.mul(wing.axes, uw), back) * wing.handedness;
            ww = math.mul(math.mul(wing.axes, ww), back);
            float mass = wing.mass, arm = mass * wing.length, turn = arm * wing.length;
            for (int i = 0, entry = 0; i < 6; i++)
            {
                for (int j = i; j < 6; j++, entry++)
                    damping[entry] += i >= 3 ? ww[j - 3][i - 3] * turn : j >= 3 ? uw[j - 3][i] * arm : uu[j][i] * mass;
            }
        }

        private static unsafe float3x3 Block(LaneAir* air, int lane, int row, int column)
        {
            float3x3 block = default;
            for (int j = 0; j < 3; j++)
            {
                block[j] = new float3(
                    air->Damping(Symmetric6.At(row, column + j), lane), air->Damping(Symmetric6.At(row + 1, column + j), lane),
                    air->Damping(Symmetric6.At(row + 2, column + j), lane));
            }

            return block;
        }
    }
}
