using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Four wings that share a rig and its model options: pointers to their live state in one block that <see cref="PackMemory"/> owns;
    /// arrays are indexed by joint or bone, every element holds the four wings.
    /// </summary>
    /// <remarks>
    /// 696 bytes a pack, by value in the array of the step job: a kernel finds counts and arrays of its pack with one load. Behind it lies
    /// one block, of 15,712 bytes a wing of a monarch, each array on cache lines of its own, of which the poses within the step are the
    /// largest part: rendering takes any time within a step without stepping again. Every byte of the block belongs to a lane, so that a
    /// wing moves to another pack by copying each fourth float.
    /// </remarks>
    internal unsafe struct WingPack
    {
        /// <summary>Number of poses kept of a step, so that rendering can pick any time within the step.</summary>
        public const int PoseSlots = 13;

        /// <summary>Number of wings in a pack.</summary>
        public const int Lanes = 4;

        public RigView rig;
        public ModelOptions options;
        public WingUpdateMode clock;
        public WingDetail detail;

        /// <summary>True where a wing of the pack carries a flying body.</summary>
        public bool carries;

        public LaneParameters* parameters;
        public LaneSurroundings* surroundings;

        /// <summary>[angle · stride + term] Series of the prescribed motion; see <see cref="WingKinematics"/>.</summary>
        public float4* series;
        public PackReadings* readings;

        /// <summary>Air that the wake has set moving.</summary>
        public LaneInflow* inflow;

        /// <summary>Air of the last substep.</summary>
        public LaneAir* air;

        /// <summary>
        /// Masses of the joints and their motion at the end of the last substep; only with <see cref="ModelOptions.bodyReaction"/>.
        /// </summary>
        public LaneMomentum* momentum;
        public BeatState* beat;

        /// <summary>Bending stiffness per bone, from the parameters and the rig.</summary>
        public float4* bendStiffness;

        /// <summary>Damping of the bend per bone, 2ζ √(stiffness · inertia).</summary>
        public float4* bendDamping;

        /// <summary>Stiffness per bone in torsion.</summary>
        public float4* torsionStiffness;

        /// <summary>Damping per bone in torsion.</summary>
        public float4* torsionDamping;

        /// <summary>1/θ² per bone, θ the bend at which the joint has become twice as stiff; 0 where it does not stiffen.</summary>
        public float4* bendStiffening;

        /// <summary>Delay of each chain, radians.</summary>
        public float4* chainDelays;

        /// <summary>Bend angles per bone: x about the bend axis, y in the plane, z torsion; radians.</summary>
        public SoaFloat3* bendAngles;

        /// <summary>Rates of the bend angles, rad/s.</summary>
        public SoaFloat3* bendRates;

        /// <summary>Bend angles one substep earlier.</summary>
        public SoaFloat3* earlierAngles;

        /// <summary>Rates of the bend angles one substep earlier, rad/s.</summary>
        public SoaFloat3* earlierRates;

        /// <summary>Length of the last substep, seconds; 0 for a wing without a past, which then takes a step of backward Euler.</summary>
        public float4* lastSubstep;

        /// <summary>Rotation H per bone: driven and bent.</summary>
        public SoaQuaternion* bentRotations;

        /// <summary>Rotation G per bone: driven alone, of the last substep.</summary>
        public SoaQuaternion* drivenRotations;

        /// <summary>Position d per joint: driven, of the last substep.</summary>
        public SoaFloat3* drivenPositions;

        /// <summary>
        /// Part of the mean driven velocity of a substep that its driven velocity does not contain; 0 except for backward Euler.
        /// </summary>
        public SoaFloat3* drivenLags;

        /// <summary>
        /// Speed of the driven joint along its normal in the last substep, L/s; only with <see cref="ModelOptions.addedMass"/>.
        /// </summary>
        public float4* normalSpeeds;

        /// <summary>The same one substep earlier, L/s.</summary>
        public float4* earlierNormalSpeeds;

        /// <summary>Deviation e per joint: elastic minus posed position, wing lengths.</summary>
        public SoaFloat3* offsets;

        /// <summary>Rate ė of the deviation per joint, L/s.</summary>
        public SoaFloat3* offsetRates;

        /// <summary>Deviation e one substep earlier, turned with the driven motion since.</summary>
        public SoaFloat3* earlierOffsets;

        /// <summary>Rate ė one substep earlier, turned with the driven motion since.</summary>
        public SoaFloat3* earlierOffsetRates;

        /// <summary>Motion of each joint's frame against its driven one in the last substep.</summary>
        public JointMotion* motions;

        /// <summary>
        /// Aerodynamic loads per patch of the last substep, and behind them <see cref="RecordedJointForces"/>; null unless recording.
        /// </summary>
        public PatchLoad* recordedLoads;

        /// <summary>[joint] Current pose, at the start of the next substep.</summary>
        public JointPose* pose;

        /// <summary>[slot][joint] Poses within the last step, every <see cref="slotStride"/> substeps; slot 0 is its start.</summary>
        public JointPose* slots;

        /// <summary>Start of the state that a substep changes, poses of the step apart, and how many float4 it has.</summary>
        public float4* state;
        public int stateCount;

        /// <summary>Number of substeps of each wing's last step; 0 before the first.</summary>
        public float4 substeps;

        /// <summary>Length of each of those substeps, seconds; while a step is planned, of all together.</summary>
        public float4 substepLength;

        /// <summary>Number of substeps from slot to slot of each wing; the last slot may follow sooner.</summary>
        public float4 slotStride;

        /// <summary>
        /// [joint] Force of the air in the last substep beside that of the patches: of the added mass, and what the deformation has changed
        /// in the substep, wing mass · L/s²; only while recording.
        /// </summary>
        public readonly SoaFloat3* RecordedJointForces => (SoaFloat3*)(recordedLoads + rig.patchCount);

        /// <summary>Number of float4 in what is recorded.</summary>
        public readonly int RecordedCount => (rig.patchCount * sizeof(PatchLoad) + rig.jointCount * sizeof(SoaFloat3)) / sizeof(float4);

        /// <summary>Writes the parameters of one wing, which are in range.</summary>
        public readonly void Set(int lane, in WingParameters p)
        {
            parameters->Set(lane, p);
            inflow->Set(lane, p.inflow);
            for (int k = 0; k < WingKinematics.Count; k++)
                series[k][lane] = p.kinematics.At(k);
        }
    }

    /// <summary>One joint's frame: S and the joint's position r; lane = wing.</summary>
    /// <remarks>
    /// 28 bytes a wing: rotation and position together, because frames and skin read both at once.
    /// </remarks>
    internal struct JointPose
    {
        public SoaQuaternion rotation;
        public SoaFloat3 position;
    }

    /// <summary>Mean rates of one joint's deformation over the last substep.</summary>
    internal struct JointMotion
    {
        /// <summary>Rate of r − d, the joint's position less its driven one, L/s.</summary>
        public SoaFloat3 velocity;

        /// <summary>Rate of the quaternion G⁻¹S, the joint's frame relative to its driven one, 1/s.</summary>
        public SoaQuaternion turning;
    }

    /// <summary>Aerodynamic load on one patch.</summary>
    internal struct PatchLoad
    {
        /// <summary>Force, wing mass · L/s².</summary>
        public SoaFloat3 force;

        /// <summary>Estimate of −dF/dv, for the implicit bending step.</summary>
        public float4 damping;

        /// <summary>Sine of the angle of attack.</summary>
        public float4 sinAttack;
    }

    /// <summary>Readings of four wings after their last step.</summary>
    /// <remarks>
    /// 56 bytes a wing, apart from the state: the main thread reads them between steps, and kernels add to them once a substep.
    /// </remarks>
    internal struct PackReadings
    {
        /// <summary>Aerodynamic force, mean over the substeps of the last step, wing mass · L/s².</summary>
        public SoaFloat3 airForce;

        /// <summary>
        /// Moment of that force about <see cref="LaneSurroundings.hinge"/>'s origin, mean over the substeps of the last step, wing mass ·
        /// L²/s².
        /// </summary>
        public SoaFloat3 airMoment;

        /// <summary>Power that the wing gives to the air, mean over the substeps of the last step, wing mass · L²/s³.</summary>
        public float4 airPower;

        /// <summary>
        /// Power that the motion of the wing's own mass takes, mean over the substeps of the last step, wing mass · L²/s³.
        /// </summary>
        public float4 inertialPower;

        /// <summary>Mean of the positive part of both powers together, wing mass · L²/s³.</summary>
        public float4 positivePower;

        /// <summary>Kinetic energy of the joints in the last substep, against the body, wing mass · L²/s².</summary>
        public float4 kineticEnergy;

        /// <summary>Spring energy (Eq. 12) at the end, wing mass · L²/s².</summary>
        public float4 springEnergy;

        /// <summary>Largest |l/L − 1| of any spring at the end.</summary>
        public float4 stretch;

        /// <summary>Factorisations of the springs' Hessian, mean over the substeps of the last step.</summary>
        public float4 newtonIterations;

        /// <summary>Number of times the wing was reset because its state was not finite.</summary>
        public float4 resets;
    }
}
