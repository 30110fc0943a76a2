using System.Collections.Generic;

namespace Alate.Flight
{
    /// <summary>Finds where the mass of a wing lies on average while it beats on the spot.</summary>
    internal static class WingMass
    {
        /// <summary>Beats until the mean places are steady, and beats that are averaged.</summary>
        private const int k_SettledBeats = 4, k_MeanBeats = 1;

        /// <summary>[rig and parameters] Measurements kept from before: all wings of a swarm, right and left, are alike.</summary>
        private static readonly Dictionary<uint, MassSum> s_Measured = new Dictionary<uint, MassSum>();

        /// <summary>
        /// Sums the masses of the joints at their mean places, the wing's mass 1, in wing lengths in the wing's frame. Do not change it.
        /// </summary>
        public static MassSum Of(FlightWing wing)
        {
            uint key = KeyOf(wing);
            if (!s_Measured.TryGetValue(key, out MassSum sum))
                s_Measured.Add(key, sum = Measure(wing.Rig, wing.Parameters));
            return sum;
        }

        private static uint KeyOf(FlightWing wing)
        {
            FlightKey key = FlightKey.Exact;
            key.Add(wing);
            for (int joint = 0; joint < wing.Rig.JointCount; joint++)
            {
                key.Add(wing.Rig.JointMasses[joint]);
                key.Add(wing.Rig.RestJoints[joint]);
            }

            return key.Value;
        }

        private static MassSum Measure(WingRig rig, in WingParameters parameters)
        {
            using var world = new WingWorld();
            WingHandle handle = world.Add(rig, parameters);
            world.SetDrive(handle, new WingDrive { frequency = parameters.maxFrequency, amplitude = 1f });
            int substeps = parameters.substepsPerBeat, samples = k_MeanBeats * substeps;
            float h = 1f / (parameters.maxFrequency * substeps);
            for (int k = 0; k < k_SettledBeats * substeps; k++)
                world.Step(h);
            var sum = new MassSum();
            for (int k = 0; k < samples; k++)
            {
                world.Step(h);
                WingReading reading = world.Read(handle);
                for (int joint = 0; joint < rig.JointCount; joint++)
                {
                    sum.Add(rig.JointMasses[joint] / (double)samples,
                        reading.JointPosition(joint / rig.JointsPerChain, joint % rig.JointsPerChain), default);
                }
            }

            return sum;
        }
    }
}
