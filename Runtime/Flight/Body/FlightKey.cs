using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Number that changes with the numbers that a trim table depends on: all but where the hinges lie on the mesh, which differs by
    /// rounding.
    /// </summary>
    internal struct FlightKey
    {
        private uint m_Hash;
        private bool m_IsExact;

        /// <summary>Key so far.</summary>
        public readonly uint Value => m_Hash;

        /// <summary>Key without anything.</summary>
        public static FlightKey Empty => new FlightKey { m_Hash = 2166136261 };

        /// <summary>Key without anything that takes in all bits of numbers.</summary>
        public static FlightKey Exact => new FlightKey { m_Hash = Empty.m_Hash, m_IsExact = true };

        /// <summary>Takes in a number.</summary>
        /// <remarks>Unless the key is exact, less its last bits: libraries of mathematics differ there.</remarks>
        public void Add(float value) => Add(m_IsExact ? math.asuint(value) : (math.asuint(value) + 128) >> 8);

        /// <summary>Takes in a number.</summary>
        public void Add(uint value)
        {
            // Fowler, Noll and Vo, byte by byte.
            for (int k = 0; k < 32; k += 8)
                m_Hash = (m_Hash ^ (value >> k & 255)) * 16777619;
        }

        /// <summary>Takes in a vector.</summary>
        public void Add(float3 value)
        {
            Add(value.x);
            Add(value.y);
            Add(value.z);
        }

        /// <summary>Takes in a wing.</summary>
        public void Add(FlightWing wing)
        {
            WingParameters parameters = wing.Parameters;
            // The unit of stiffness follows from length and mass.
            foreach (WingParameterRange range in WingParameters.s_Ranges)
            {
                if (range.Name != nameof(WingParameters.stiffnessUnit))
                    Add(range.Of(ref parameters));
            }

            Add(wing.Rig.Beams);
            for (int bone = 0; wing.Rig.VeinFactors != null && bone < wing.Rig.VeinFactors.Length; bone++)
                Add(wing.Rig.VeinFactors[bone]);
            Add((uint)parameters.substepsPerBeat);
            ModelOptions o = parameters.options;
            Add((uint)o.coefficients * 1024 + (uint)o.tangent * 256 + (o.clampLift ? 128u : 0u) + (o.addedMass ? 4096u : 0u)
                + (o.bodyReaction ? 8192u : 0u) + (o.attachedRotation ? 16384u : 0u)
                + (uint)o.cycleChange * 64
                + (uint)o.torqueArm * 16 + (uint)o.springUnits * 8 + (uint)o.coupling * 4 + (uint)o.timeScheme);
            Add(parameters.kinematics);
            Add(parameters.inflow);
            Add(wing.Length);
            Add(wing.Mass);
            Add(wing.GravityShare);
        }

        // Nothing where no stiffness is measured.
        private void Add(BeamHinges beams)
        {
            for (int bone = 0; bone < beams.bend.Length; bone++)
            {
                if (beams.bend[bone] == 0f)
                    continue;
                Add((uint)bone);
                Add(beams.bend[bone]);
                Add(beams.torsion[bone]);
            }
        }

        // Nothing where no motion is prescribed.
        private void Add(in WingKinematics kinematics)
        {
            if (!kinematics.IsSet)
                return;
            Add(kinematics.frequency);
            Add(kinematics.waves ? 1u : 0u);
            for (int k = 0; k < WingKinematics.Count; k++)
                Add(kinematics.At(k));
        }

        // Nothing where no wake blows.
        private void Add(in WingInflow inflow)
        {
            if (!inflow.IsSet)
                return;
            Add(inflow.mean);
            Add(inflow.cosine1);
            Add(inflow.sine1);
            Add(inflow.cosine2);
            Add(inflow.sine2);
        }
    }
}
