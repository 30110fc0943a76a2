using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Force, moment and power of the air at the end of a substep. The loads are made with the rate of the deformation of the substep
    /// before, from which the hinges' damping carries them on; what is read is carried on in the same way. Without it the lift of a soft
    /// wing is too small by a share that falls with the substep alone: 20 % of a hovering fishfly's at 16 substeps a beat, with it 3 %.
    /// </summary>
    internal static unsafe class AirReadings
    {
        /// <summary>
        /// Adds force and moment of the air and powers to the readings; after the new pose, before its motions replace those of the
        /// substep before.
        /// </summary>
        public static void Evaluate(in WingPack pack, in StepScratch scratch, in ImplicitStep step)
        {
            if (pack.options.timeScheme == TimeScheme.BackwardEuler)
                Keep(pack, scratch);
            else
                CarryOn(pack, scratch, step.dt);
            SumForces(pack, scratch, pack.options.timeScheme == TimeScheme.BackwardEuler ? scratch.carriedPositions : scratch.positions);
            Read(pack, step.dt, SumPower(pack, scratch));
        }

        // The loads as they were made, with the velocities that made them.
        private static void Keep(in WingPack pack, in StepScratch scratch)
        {
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                scratch.endLoads[joint] = scratch.airForces[joint];
                scratch.endVelocities[joint] = scratch.drivenVelocities[joint] + pack.motions[joint].velocity;
            }
        }

        // The loads and velocities of the end of the substep.
        private static void CarryOn(in WingPack pack, in StepScratch scratch, float4 dt)
        {
            var rates = new EndRates(pack, dt);
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 normal = scratch.carriedFrames[joint].c1, rate = rates.Of(pack, scratch, joint);
                SoaFloat3 faster = rate - pack.motions[joint].velocity;
                SoaFloat3 change = normal * (-scratch.airDamping[joint] * SoaFloat3.Dot(normal, faster));
                scratch.endLoads[joint] = scratch.airForces[joint] + change;
                scratch.endVelocities[joint] = scratch.drivenVelocities[joint] + rate;
                if (pack.recordedLoads != null)
                    pack.RecordedJointForces[joint] += change;
            }
        }

        // In passes with few sums each, which stay in registers.
        private static void SumForces(in WingPack pack, in StepScratch scratch, SoaFloat3* positions)
        {
            SoaFloat3 force = default, moment = default;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 load = scratch.endLoads[joint];
                force += load;
                moment += SoaFloat3.Cross(positions[joint], load);
            }

            pack.air->force = force;
            pack.air->moment = moment + SoaFloat3.Cross(pack.surroundings->hinge, force);
        }

        // Returns the kinetic energy.
        private static float4 SumPower(in WingPack pack, in StepScratch scratch)
        {
            float4 power = 0f, energy = 0f;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 velocity = scratch.endVelocities[joint];
                power -= SoaFloat3.Dot(scratch.endLoads[joint], velocity);
                energy += 0.5f * pack.rig.jointMasses[joint] * SoaFloat3.LengthSquared(velocity);
            }

            pack.air->power = power;
            return energy;
        }

        // Power is what the wing gives to the air, less force times velocity, and what its own mass takes, the rate of its kinetic energy;
        // a wing without a past has no rate.
        private static void Read(in WingPack pack, float4 dt, float4 energy)
        {
            LaneAir* air = pack.air;
            PackReadings* readings = pack.readings;
            float4 inertial = math.select((energy - readings->kineticEnergy) / dt, 0f, *pack.lastSubstep <= 0f);
            readings->airForce += air->force;
            readings->airMoment += air->moment;
            readings->airPower += air->power;
            readings->inertialPower += inertial;
            readings->positivePower += math.max(air->power + inertial, 0f);
            readings->kineticEnergy = energy;
        }
    }
}
