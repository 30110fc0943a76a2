using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Hinges and inertias of the chains of measured stiffness; lengths in wing lengths, stiffness in N·m² per wing length.
    /// </summary>
    /// <remarks>
    /// Joints are stepped one by one: each with the inertia of what lies beyond it would swing at a frequency of its own, the root of four
    /// bones 1.5 times too fast. So the inertia of a hinge here is its stiffness over the square of the chain's first bending frequency;
    /// the hinges swing together, as the beam does in its first mode.
    /// </remarks>
    internal sealed class BeamHinges
    {
        /// <summary>Parts of each bone for the first bending frequency, which four bones alone have 2 % too low.</summary>
        private const int k_Parts = 8;

        /// <summary>[bone] Stiffness of the inner joint in bending; 0 where the stiffness is not measured.</summary>
        public readonly float[] bend;

        /// <summary>[bone] Stiffness of the inner joint in torsion; 0 where it is not measured.</summary>
        public readonly float[] torsion;

        /// <summary>[bone] Inertias of the joints.</summary>
        public readonly float[] inertias;

        /// <param name="skeleton">A valid one.</param>
        /// <param name="rest">The same at rest.</param>
        /// <param name="masses">[joint]</param>
        /// <param name="inertias">[bone] Of what lies beyond each joint; those of measured chains are replaced.</param>
        public BeamHinges(WingSkeleton skeleton, RestSkeleton rest, float[] masses, float[] inertias)
        {
            this.inertias = inertias;
            bend = new float[rest.BoneCount];
            torsion = new float[rest.BoneCount];
            for (int i = 0; i < rest.chainCount; i++)
            {
                JointChain chain = skeleton.Chains[i];
                if (ChainValues.AreGiven(chain.flexuralStiffness))
                    Add(chain, i, rest, masses);
            }
        }

        private void Add(in JointChain chain, int index, RestSkeleton rest, float[] masses)
        {
            int joints = rest.jointsPerChain, first = index * (joints - 1);
            double[] places = new double[joints], distances = new double[joints], own = new double[joints];
            for (int j = 0; j < joints; j++)
            {
                places[j] = (double)j / (joints - 1);
                distances[j] = j == 0 ? 0.0 : distances[j - 1] + math.length(rest.bones[first + j - 1]);
                own[j] = masses[index * joints + j];
            }

            var beam = new ChainBeam(places, distances);
            ChainBeam fine = beam.Cut(k_Parts);
            double[] hinges = beam.Hinges(chain.flexuralStiffness);
            double[] twists = ChainValues.AreGiven(chain.torsionalStiffness) ? beam.Twists(chain.torsionalStiffness) : null;
            double swing = fine.SwingTimeSquared(beam.Spread(own, k_Parts), fine.Hinges(chain.flexuralStiffness));
            for (int j = 0; j + 1 < joints; j++)
            {
                bend[first + j] = (float)hinges[j];
                torsion[first + j] = twists == null ? 0f : (float)twists[j];
                inertias[first + j] = (float)(hinges[j] * swing);
            }
        }
    }
}
