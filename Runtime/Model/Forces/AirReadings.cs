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
            float4 energy = Seen(pack, scratch);
            if (pack.options.timeScheme != TimeScheme.BackwardEuler)
                energy = Settle(pack, scratch, step.dt);
            Read(pack, step.dt, energy);
        }

        // Of the loads as they were made; returns the kinetic energy.
        private static float4 Seen(in WingPack pack, in StepScratch scratch)
        {
            SoaFloat3 force = default, moment = default;
            float4 power = 0f, energy = 0f;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 load = scratch.airForces[joint], velocity = scratch.drivenVelocities[joint] + pack.motions[joint].velocity;
                force += load;
                moment += SoaFloat3.Cross(scratch.carriedPositions[joint], load);
                power -= SoaFloat3.Dot(load, velocity);
                energy += 0.5f * pack.rig.jointMasses[joint] * SoaFloat3.LengthSquared(velocity);
            }

            pack.air->force = force;
            pack.air->moment = moment + SoaFloat3.Cross(pack.surroundings->hinge, force);
            pack.air->power = power;
            return energy;
        }

        // Adds what the end of the substep differs by; returns the kinetic energy there. In three passes with few sums each, which stay in
        // registers.
        private static float4 Settle(in WingPack pack, in StepScratch scratch, float4 dt)
        {
            Changes(pack, scratch, dt);
            SettleForce(pack, scratch);
            return SettlePower(pack, scratch);
        }

        private static void Changes(in WingPack pack, in StepScratch scratch, float4 dt)
        {
            var rates = new EndRates(pack, dt);
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 normal = scratch.carriedFrames[joint].c1;
                SoaFloat3 faster = rates.Of(pack, scratch, joint) - pack.motions[joint].velocity;
                scratch.rateChanges[joint] = faster;
                scratch.forceChanges[joint] = normal * (-scratch.airDamping[joint] * SoaFloat3.Dot(normal, faster));
                if (pack.recordedLoads != null)
                    pack.RecordedJointForces[joint] += scratch.forceChanges[joint];
            }
        }

        private static void SettleForce(in WingPack pack, in StepScratch scratch)
        {
            SoaFloat3 force = default, moment = default;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 load = scratch.airForces[joint], given = scratch.forceChanges[joint], position = scratch.pose[joint].position;
                force += given;
                moment += SoaFloat3.Cross(position, load + given) - SoaFloat3.Cross(scratch.carriedPositions[joint], load);
            }

            pack.air->force += force;
            pack.air->moment += moment + SoaFloat3.Cross(pack.surroundings->hinge, force);
        }

        private static float4 SettlePower(in WingPack pack, in StepScratch scratch)
        {
            float4 power = 0f, energy = 0f;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 faster = scratch.rateChanges[joint];
                SoaFloat3 velocity = scratch.drivenVelocities[joint] + pack.motions[joint].velocity + faster;
                power -= SoaFloat3.Dot(scratch.forceChanges[joint], velocity) + SoaFloat3.Dot(scratch.airForces[joint], faster);
                energy += 0.5f * pack.rig.jointMasses[joint] * SoaFloat3.LengthSquared(velocity);
            }

            pack.air->power += power;
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
