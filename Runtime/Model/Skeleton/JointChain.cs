using System;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// One chain of joints of a <see cref="WingSkeleton"/>, radiating from the wing's base, and what is known of it: its measured
    /// stiffness, the vein that it lies on.
    /// </summary>
    /// <remarks>
    /// A list has one value for the whole chain, or two for root and tip, or more, at most <see cref="WingSkeleton.MaxJoints"/>, spread
    /// evenly over the joints from root to tip; between two values the stiffness changes geometrically, a width linearly. An empty list
    /// leaves the chain to the factors of the preset.
    /// </remarks>
    [Serializable]
    [MovedFrom(true, null, "Alate")]
    public struct JointChain
    {
        /// <summary>Rest positions from root to tip, mesh space.</summary>
        [Tooltip("Positions from root to tip, mesh units.")]
        public Vector3[] joints;

        /// <summary>
        /// Flexural stiffness EI from root to tip, N·m², 10⁻¹⁵ to 1000 each, of the real wing's size; empty where it is not known. In place
        /// of the preset's elasticity, leading and trailing edge and decay; the dorsal asymmetry still multiplies it when the chain bends
        /// up.
        /// </summary>
        [Tooltip("Measured flexural stiffness EI from root to tip, N·m², 1e-15 to 1000: one value, root and tip, or more. Empty: the "
            + "preset's factors. All chains of a monarch together have 3e-5 by its factors: a third of that hangs in the wind, ten times "
            + "as much is a stiff sheet.")]
        public float[] flexuralStiffness;

        /// <summary>
        /// Torsional stiffness GJ from root to tip, N·m², 10⁻¹⁵ to 1000 each; empty where it is not known: then the preset's torsion factor
        /// times the stiffness in bending. Needs <see cref="flexuralStiffness"/>.
        /// </summary>
        [Tooltip("Measured torsional stiffness GJ from root to tip, N·m², 1e-15 to 1000. Empty: the preset's torsion factor times the "
            + "stiffness in bending. Needs a flexural stiffness.")]
        public float[] torsionalStiffness;

        /// <summary>
        /// Widths of the vein that the chain lies on, from root to tip, 0 to 10⁶ each, in one unit for the whole wing, such as millimetres:
        /// only their ratios count. 0 is membrane. Empty: membrane where other chains have widths, else the veins of the wing are unknown,
        /// and all chains are alike.
        /// </summary>
        [Tooltip("Widths of the vein under the chain from root to tip, in any unit that is one for the whole wing; 0 is membrane. A vein "
            + "twice as wide is eight times as stiff; the wing's mean stiffness stays. Empty on all chains: veins unknown.")]
        public float[] veinWidths;

        /// <summary>A chain of these joints, of unknown stiffness.</summary>
        /// <param name="joints">Rest positions from root to tip, mesh space; kept, not copied.</param>
        public JointChain(params Vector3[] joints)
        {
            this.joints = joints;
            flexuralStiffness = null;
            torsionalStiffness = null;
            veinWidths = null;
        }

        /// <summary>Joints of the chain; 0 when there is no array.</summary>
        public int Length => joints?.Length ?? 0;
    }
}
