using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Rig as passed to jobs: counts and pointers into native memory that a <see cref="WingRig"/> owns. All lengths are in wing lengths, in
    /// the wing frame, unless said otherwise; n chains of m joints. Joint index = chain · m + joint; bone index = chain · (m−1) + inner
    /// joint; cell index = forward chain · (m−1) + inner joint.
    /// </summary>
    /// <remarks>
    /// 320 bytes a rig, and none a wing but its copy in the pack's header: all wings with the same mesh and skeleton read one copy of the
    /// arrays.
    /// </remarks>
    internal unsafe struct RigView
    {
        public int chainCount;
        public int jointsPerChain;
        public int jointCount;
        public int boneCount;
        public int cellCount;
        public int springCount;
        public int stripCount;
        public int patchCount;
        public int vertexCount;
        public int quadCount;

        /// <summary>e_LE: unit vector from root to tip of the principal chain, the axis of feathering.</summary>
        public float3 leadingEdge;

        /// <summary>Largest distance of a vertex from the place between its joints that its weights name, mesh units.</summary>
        public float skinReach;

        /// <summary>
        /// [n] ρ_i of Eq. 2: distance of the chain's root from the first chain's, over that of the last chain's; i/(n−1) when all roots are
        /// one.
        /// </summary>
        public float* chainRatio;

        /// <summary>[m] σ_j = j/(m−1).</summary>
        public float* jointRatio;

        /// <summary>[joint] p_ij: rest positions.</summary>
        public float3* restJoints;

        /// <summary>[bone] p_i,j+1 − p_ij.</summary>
        public float3* bones;

        /// <summary>[bone] t_ij: unit vectors along the bones.</summary>
        public float3* boneDirections;

        /// <summary>[bone] b_ij = unit(t × Y): positive bend lifts the tip.</summary>
        public float3* bendAxes;

        /// <summary>
        /// [bone] From the middle of the bone on the chain before to that on the chain after, one-sided at the first and last chain.
        /// </summary>
        public float3* crossDirections;

        /// <summary>[joint] Mass; the sum is 1, each is above 0.</summary>
        public float* jointMasses;

        /// <summary>
        /// [bone] I_ij = Σ_{k&gt;j} m_ik |p_ik−p_ij|²; on a chain of measured stiffness, that which lets every joint swing at the chain's
        /// first bending frequency.
        /// </summary>
        public float* jointInertias;

        /// <summary>[joint] Mass of the air that a joint carries along across the surface, over the air's density, L³.</summary>
        public float* addedMasses;

        /// <summary>[bone] Inertia of that air beyond the bone, over the air's density, L⁵.</summary>
        public float* addedInertias;

        /// <summary>[bone] Measured stiffness of the joint in bending, N·m² per wing length; 0 where the preset's factors hold.</summary>
        public float* beamStiffness;

        /// <summary>[bone] Measured stiffness of the joint in torsion, N·m² per wing length; 0 where the torsion factor holds.</summary>
        public float* beamTorsion;

        /// <summary>
        /// [bone] Factor on the stiffness that the preset's factors make, by the width of the vein there; 1 where no veins are known.
        /// </summary>
        public float* veinFactors;

        /// <summary>True where the skeleton knows veins.</summary>
        public bool hasVeins;

        /// <summary>
        /// [(i·m + j)·m + k] For k &gt; j |p_ik−p_ij| Λ_ik with Λ_ik = Σ_{l&lt;k} |p_ik−p_il|, else 0: turns the air's damping at
        /// joint k into that of the bend at joint j.
        /// </summary>
        public float* leverDamping;

        /// <summary>
        /// [spring] Springs along chains, across neighbouring chains and along both diagonals of each cell; none between two roots.
        /// </summary>
        public Spring* springs;

        /// <summary>[strip] Places between neighbouring chains where their bends are compared.</summary>
        public Strip* strips;

        /// <summary>Slopes of the strips by the bends of their chains; see <see cref="Strip.lever"/>.</summary>
        public float* stripLevers;

        /// <summary>
        /// Spread of the chains: 1 for a fan, towards 0 for a ribbon, whose membrane would be sheared by chains that move independently.
        /// </summary>
        public float spread;

        /// <summary>[bone] Share of the flap that is added to the root's from the root to this bone, 0 to 1.</summary>
        public float* flapShares;

        /// <summary>
        /// [n − 1] Narrowest width between a chain and the next one, over the distance from the root; infinite where no joint has a foot on
        /// the other chain.
        /// </summary>
        public float* fanWidths;

        /// <summary>[cell] Patches of each cell, in order.</summary>
        public PatchCell* patchCells;

        /// <summary>[patch] Bilinear coordinate of the centre across the chains, in [0, 1].</summary>
        public float* patchU;

        /// <summary>[patch] Bilinear coordinate of the centre along the chains, in [0, 1].</summary>
        public float* patchV;

        /// <summary>[patch] Rest centre along the span, x.</summary>
        public float* patchSpan;

        /// <summary>[patch] Rest centre forward of the hinge, z.</summary>
        public float* patchChord;

        /// <summary>[patch] Quarter of the wing's chord at the centre, L.</summary>
        public float* patchQuarterChords;

        /// <summary>[patch] Rest area, L².</summary>
        public float* patchAreas;

        /// <summary>[patch] 1/|x_u × x_v| at rest, L⁻²: times the current |x_u × x_v|, the growth of the area.</summary>
        public float* patchMeasures;

        /// <summary>[cell] Vertices of each cell, in order.</summary>
        public SkinCell* skinCells;

        /// <summary>[quad] Vertices, four at a time, in mesh space.</summary>
        public SkinQuad* skinQuads;

        /// <summary>[quad] Tangents beside <see cref="skinQuads"/>; null when the mesh has none.</summary>
        public SkinTangentQuad* skinTangents;

        /// <summary>Number of blocks below the diagonal of the banded Hessian.</summary>
        public readonly int BandBlocks => chainCount * (jointsPerChain - 1) * jointsPerChain;

        /// <summary>Index of the bone that goes out from a joint; for the last joint of a chain, of the bone that comes in.</summary>
        public readonly int BoneOf(int joint)
        {
            int chain = joint / jointsPerChain;
            return chain * (jointsPerChain - 1) + math.min(joint - chain * jointsPerChain, jointsPerChain - 2);
        }
    }
}
