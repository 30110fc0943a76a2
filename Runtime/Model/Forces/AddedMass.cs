using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Force of the air that a thin wing carries along where it is accelerated across its surface: ρ π/4 · c · A · d(V·n)/dt along the
    /// normal n, with the local chord c and the air V that the surface meets (Sedov 1965; of flapping wings Sane and Dickinson 2002). Only
    /// the driven motion is accelerated here; the deformation feels the same mass as inertia of its hinges, implicitly, because it may
    /// exceed the wing's own.
    /// </summary>
    internal static unsafe class AddedMass
    {
        /// <summary>Adds the forces to the joints'; call after <see cref="CarriedSurface"/>.</summary>
        public static void Apply(in WingPack pack, in StepScratch scratch, in ImplicitStep step)
        {
            SoaFloat3 body = pack.surroundings->angularVelocity, hinge = pack.surroundings->hinge,
                wind = pack.surroundings->boundWind + pack.inflow->velocity;
            bool4 fresh = *pack.lastSubstep <= 0f;
            float4 inverse = 1f / step.length;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                int bone = pack.rig.BoneOf(joint);
                SoaFloat3 normal = SoaQuaternion.Rotate(scratch.drivenRotations[bone], new SoaFloat3(0f, 1f, 0f));
                float4 speed = SoaFloat3.Dot(scratch.drivenVelocities[joint], normal);
                float4 now = math.select(pack.normalSpeeds[joint], speed, fresh),
                    earlier = math.select(pack.earlierNormalSpeeds[joint], speed, fresh);
                float4 rate = (speed - now * step.now + earlier * step.before) * inverse;
                pack.earlierNormalSpeeds[joint] = now;
                pack.normalSpeeds[joint] = speed;

                // A steady stream changes its part across the surface where the surface turns.
                SoaFloat3 stream = wind - SoaFloat3.Cross(body, scratch.carriedPositions[joint] + hinge);
                float4 turned = SoaFloat3.Dot(stream, SoaFloat3.Cross(scratch.angularVelocity[bone], normal));
                SoaFloat3 force =
                    scratch.carriedFrames[joint].c1 * ((turned - rate) * pack.parameters->numbers.airDensity * pack.rig.addedMasses[joint]);
                scratch.forces[joint] += force;
                if (pack.recordedLoads != null)
                    pack.RecordedJointForces[joint] = force;
            }
        }
    }
}
