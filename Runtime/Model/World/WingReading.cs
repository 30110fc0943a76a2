using System;
using System.Diagnostics;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// The state of one wing at the end of the last step, read in place: wing frame, wing lengths, wing masses, radians. Valid until the
    /// next call that steps or changes the <see cref="WingWorld"/> it came from; then, where Unity's safety checks are on, it throws
    /// <see cref="InvalidOperationException"/>.
    /// </summary>
    [MovedFrom(true, null, "Alate")]
    public readonly unsafe struct WingReading
    {
        private readonly WingPack m_Pack;
        private readonly int m_Lane;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        private readonly JobArrays m_Source;
        private readonly int m_Version;
#endif

        internal WingReading(JobArrays source, WingEntry entry)
        {
            m_Pack = source.Pack(entry.pack);
            m_Lane = entry.lane;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            m_Source = source;
            m_Version = source.Version;
#endif
        }

        /// <summary>Number of chains, n; joints are addressed by chain 0…n−1 and joint 0…m−1.</summary>
        public int ChainCount => m_Pack.rig.chainCount;

        /// <summary>Number of joints per chain, m.</summary>
        public int JointsPerChain => m_Pack.rig.jointsPerChain;

        /// <summary>Phase Φ, radians, [0, 2π).</summary>
        public float Phase => Beat->phase[m_Lane];

        /// <summary>Number of beats completed since the last reset.</summary>
        public int Beats => (int)Beat->cycles[m_Lane];

        /// <summary>Frequency of this beat (Eq. 6), hertz.</summary>
        public float Frequency => Beat->frequency[m_Lane];

        /// <summary>Half amplitudes of this beat (Eq. 7), radians: x flap, y sweep, z feather.</summary>
        public float3 Amplitude => Beat->amplitude[m_Lane];

        /// <summary>
        /// Aerodynamic force (Eq. 11) at the ends of the substeps, mean over the last step, wing masses · L/s².
        /// </summary>
        public float3 AirForce => Readings->airForce[m_Lane];

        /// <summary>
        /// Moment of <see cref="AirForce"/> about the body's reference point (<see cref="WingSurroundings.hinge"/> away from the hinge),
        /// mean over the last step, wing masses · L²/s².
        /// </summary>
        public float3 AirMoment => Readings->airMoment[m_Lane];

        /// <summary>Velocity of the air that the wake has set moving, at the end of the last step, L/s.</summary>
        internal unsafe float3 WakeVelocity => Current().inflow->velocity[m_Lane];

        /// <summary>Power that the wing gives to the air, mean over the last step, wing masses · L²/s³.</summary>
        public float AirPower => Readings->airPower[m_Lane];

        /// <summary>
        /// Power that the motion of the wing's own mass against the body takes, the rate of its kinetic energy, mean over the last step,
        /// wing masses · L²/s³. Over a beat that repeats it is 0.
        /// </summary>
        public float InertialPower => Readings->inertialPower[m_Lane];

        /// <summary>
        /// Mean of the positive part of <see cref="AirPower"/> and <see cref="InertialPower"/> together over the substeps of the last step,
        /// wing masses · L²/s³: what the muscles give where nothing stores what the wing gives back. The negative part is both less this.
        /// </summary>
        public float PositivePower => Readings->positivePower[m_Lane];

        /// <summary>Spring energy (Eq. 12), wing masses · L²/s².</summary>
        public float SpringEnergy => Readings->springEnergy[m_Lane];

        /// <summary>
        /// Largest |l/L − 1| of the membrane between any two joints, at the end of the last step; above 0.1 a wing looks torn.
        /// </summary>
        public float Stretch => Readings->stretch[m_Lane];

        /// <summary>
        /// Newton iterations, each with a factorisation of the springs' Hessian, per substep: mean over the last step; 1 where chord steps
        /// suffice.
        /// </summary>
        public float NewtonIterations => Readings->newtonIterations[m_Lane];

        /// <summary>Number of times the wing fell back to its driven pose because its state was not finite.</summary>
        public int Resets => (int)Readings->resets[m_Lane];

        /// <summary>Number of substeps of the last step.</summary>
        public int Substeps
        {
            get
            {
                float4 substeps = m_Pack.substeps;
                return (int)substeps[m_Lane];
            }
        }

        /// <summary>Position of a joint, wing lengths from the hinge.</summary>
        public float3 JointPosition(int chain, int joint) => m_Pack.pose[Joint(chain, joint)].position[m_Lane];

        /// <summary>
        /// Position of a joint at a time within the last step, 0 its start, 1 its end, wing lengths: as drawn between two steps.
        /// </summary>
        public float3 JointPosition(int chain, int joint, float alpha)
        {
            if (!PackSlots.Span(m_Pack, m_Lane, alpha, out int slot, out float blend))
                return JointPosition(chain, joint);
            int at = Joint(chain, joint);
            JointPose* before = m_Pack.slots + slot * m_Pack.rig.jointCount;
            return math.lerp(before[at].position[m_Lane], before[m_Pack.rig.jointCount + at].position[m_Lane], blend);
        }

        /// <summary>Rotation of a joint's frame out of its rest pose.</summary>
        public quaternion JointRotation(int chain, int joint) => m_Pack.pose[Joint(chain, joint)].rotation[m_Lane];

        /// <summary>Rotation that the muscles drive at a bone, before it bends.</summary>
        public quaternion DrivenRotation(int chain, int bone) => m_Pack.drivenRotations[Bone(chain, bone)][m_Lane];

        /// <summary>Bend of the joint at the root side of a bone, radians: x up, y in the plane, z torsion.</summary>
        public float3 BendAngles(int chain, int bone) => m_Pack.bendAngles[Bone(chain, bone)][m_Lane];

        /// <summary>
        /// Stiffness of the joint at the root side of a bone, wing masses · L²/s² per radian: x against bending down, y against torsion.
        /// Over <see cref="WingParameters.stiffnessUnit"/> it is in N·m² per wing length.
        /// </summary>
        public float2 JointStiffness(int chain, int bone)
        {
            int at = Bone(chain, bone);
            return new float2(m_Pack.bendStiffness[at][m_Lane], m_Pack.torsionStiffness[at][m_Lane]);
        }

        /// <summary>True where patch loads are kept; see <see cref="WingWorld.RecordPatches"/>.</summary>
        public bool HasPatchLoads => m_Pack.recordedLoads != null;

        /// <summary>Number of aerodynamic patches.</summary>
        public int PatchCount => m_Pack.rig.patchCount;

        /// <summary>
        /// Middle of a patch, between the four joints around it, wing lengths from the hinge, at a time within the last step.
        /// </summary>
        public float3 PatchPosition(int patch, float alpha = 1f)
        {
            Check(patch, PatchCount, nameof(patch));
            int cell = 0;
            while (patch >= m_Pack.rig.patchCells[cell].firstPatch + m_Pack.rig.patchCells[cell].patchCount)
                cell++;
            int chain = cell / (JointsPerChain - 1), joint = cell % (JointsPerChain - 1);
            float u = m_Pack.rig.patchU[patch], v = m_Pack.rig.patchV[patch];
            float3 ahead = math.lerp(JointPosition(chain, joint, alpha), JointPosition(chain, joint + 1, alpha), v);
            return math.lerp(ahead, math.lerp(JointPosition(chain + 1, joint, alpha), JointPosition(chain + 1, joint + 1, alpha), v), u);
        }

        /// <summary>Place of a patch along the span at rest, wing lengths from the hinge.</summary>
        internal float PatchSpan(int patch) => m_Pack.rig.patchSpan[patch];

        /// <summary>Area of a patch at rest, wing lengths².</summary>
        internal float PatchArea(int patch) => m_Pack.rig.patchAreas[patch];

        /// <summary>Place of a joint along the span at rest, wing lengths from the hinge.</summary>
        internal float JointSpan(int joint) => m_Pack.rig.restJoints[joint].x;

        /// <summary>
        /// Force of the air on a joint in the last substep beside that of the patches, wing masses · L/s²: of the added mass, and what the
        /// deformation has changed in the substep.
        /// </summary>
        /// <exception cref="InvalidOperationException">Patch loads are not kept.</exception>
        internal float3 JointForce(int joint)
        {
            Load(0);
            return m_Pack.RecordedJointForces[joint][m_Lane];
        }

        /// <summary>
        /// Force on a patch in the last substep, wing masses · L/s², as the deformation of the substep before makes it:
        /// <see cref="AirForce"/> holds what the substep changes too.
        /// </summary>
        /// <exception cref="InvalidOperationException">Patch loads are not kept.</exception>
        public float3 PatchForce(int patch) => Load(patch)->force[m_Lane];

        /// <summary>Angle of attack of a patch in the last substep (Eq. 10), radians, 0…π/2.</summary>
        /// <exception cref="InvalidOperationException">Patch loads are not kept.</exception>
        public float PatchAngleOfAttack(int patch) => Elementary.Asin(math.min(Load(patch)->sinAttack[m_Lane], 1f));

        /// <summary>
        /// Adds the force of the air in the last substep to the joints: of each patch to the four around it, as the step itself shares it
        /// out, and what joints feel beside.
        /// </summary>
        /// <param name="loads">[chain · m + joint] Wing masses · L/s².</param>
        /// <exception cref="InvalidOperationException">Patch loads are not kept.</exception>
        internal void AddJointLoads(float3[] loads)
        {
            int joints = JointsPerChain;
            for (int cell = 0, patch = 0; patch < PatchCount; cell++)
            {
                int corner = cell / (joints - 1) * joints + cell % (joints - 1), end = patch + m_Pack.rig.patchCells[cell].patchCount;
                for (; patch < end; patch++)
                {
                    float u = m_Pack.rig.patchU[patch], v = m_Pack.rig.patchV[patch];
                    float3 force = PatchForce(patch);
                    loads[corner] += (1f - u) * (1f - v) * force;
                    loads[corner + 1] += (1f - u) * v * force;
                    loads[corner + joints] += u * (1f - v) * force;
                    loads[corner + joints + 1] += u * v * force;
                }
            }

            for (int joint = 0; joint < loads.Length; joint++)
                loads[joint] += JointForce(joint);
        }

        private BeatState* Beat => Current().beat;

        private PackReadings* Readings => Current().readings;

        private WingPack Current()
        {
            CheckCurrent();
            return m_Pack;
        }

        private int Joint(int chain, int joint)
        {
            CheckCurrent();
            Check(chain, ChainCount, nameof(chain));
            Check(joint, JointsPerChain, nameof(joint));
            return chain * JointsPerChain + joint;
        }

        private int Bone(int chain, int bone)
        {
            CheckCurrent();
            Check(chain, ChainCount, nameof(chain));
            Check(bone, JointsPerChain - 1, nameof(bone));
            return chain * (JointsPerChain - 1) + bone;
        }

        private PatchLoad* Load(int patch)
        {
            CheckCurrent();
            if (!HasPatchLoads)
                throw new InvalidOperationException("Patch loads are not kept; call WingWorld.RecordPatches first.");
            Check(patch, PatchCount, nameof(patch));
            return m_Pack.recordedLoads + patch;
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        private void CheckCurrent()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            if (m_Source == null || m_Version != m_Source.Version)
            {
                throw new InvalidOperationException(
                    "This reading is out of date: its world was stepped or changed since. Read the wing again.");
            }
#endif
        }

        private static void Check(int index, int count, string name)
        {
            if ((uint)index >= (uint)count)
                throw new ArgumentOutOfRangeException(name, index, $"Must be 0 to {count - 1}.");
        }
    }
}
