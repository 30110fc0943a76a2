using Unity.Mathematics;

namespace Alate
{
    /// <summary>Working memory of one substep: one block per worker, allocated once, sized for the largest rig.</summary>
    /// <remarks>
    /// 218,304 bytes a worker for a monarch, and none a wing: what lives within a substep alone does not grow with the number of wings.
    /// Each array is on cache lines of its own, in the order in which the substep fills them.
    /// </remarks>
    internal unsafe struct StepScratch
    {
        /// <summary>Middle of the stroke and tilt, once.</summary>
        public StrokeMeans* means;

        // Waves, per bone.
        public float4* localPhase;
        public SoaFloat3* amplitude;
        public SoaFloat3* amplitudeRate;
        public SoaFloat3* amplitudeCurvature;
        public SoaFloat3* angle;
        public SoaFloat3* angleRate;
        public SoaFloat3* angleCurvature;

        // Driven pose.

        /// <summary>[bone] Sine and cosine of the flap.</summary>
        public float4* flapSin, flapCos;
        public SoaQuaternion* drivenRotations;
        public SoaFloat3* angularVelocity;
        public SoaFloat3* angularAcceleration;
        public SoaFloat3* drivenPositions;
        public SoaFloat3* drivenVelocities;
        public SoaFloat3* drivenAccelerations;

        /// <summary>[bone] Rotation of the driven frame since the last substep, G G₋₁⁻¹.</summary>
        public SoaQuaternion* turns;

        /// <summary>[joint] Rotation in the driven frame at the start of the substep.</summary>
        public SoaQuaternion* deformations;

        // Loads, per joint and per patch.
        public SoaFloat3x3* carriedFrames;
        public SoaFloat3* carriedPositions;
        public SoaFloat3* carriedSpans;

        /// <summary>[joint] Angular velocity of the carried frame, rad/s.</summary>
        public SoaFloat3* carriedTurning;
        public SoaFloat3* alongEdges;
        public SoaFloat3* acrossEdges;
        public SoaFloat3* hingeVelocities;
        public SoaFloat3* spanRates;
        public SoaFloat3* chordRates;
        public SoaFloat3* forces;

        /// <summary>[joint] Part of the forces that is the air's.</summary>
        public SoaFloat3* airForces;
        public float4* airDamping;
        public SoaFloat3* relativeWind;
        public SoaFloat3* normals;
        public float4* alongSpan;

        /// <summary>[patch] ½ρ* times the deformed area.</summary>
        public float4* halfDensityAreas;
        public PatchStream* streams;
        public PatchLoad* loads;
        public SoaFloat3* torques;
        public SoaFloat3* arms;

        /// <summary>[bone] Angle by which a unit of torque turns the hinge in this substep, about each of its axes.</summary>
        public SoaFloat3* compliances;

        /// <summary>[bone] Bend angle while chains are coupled.</summary>
        public float4* coupledAngles;

        /// <summary>[strip] Change of the strip's slope by a unit of its force, the sum of that and 1/K, and the force.</summary>
        public float4* stripCompliances;
        public float4* stripYields;
        public float4* stripForces;

        // Elasticity, per joint and per spring.
        public SoaFloat3* targets;
        public SoaFloat3* anchors;
        public float4* inertia;
        public SoaFloat3* positions;
        public SoaFloat3* candidate;

        /// <summary>[joint] Part of the last chord step's movement beyond the step itself.</summary>
        public SoaFloat3* mixing;
        public SoaFloat3* gradient;
        public SymmetricBlock* blocks;
        public SoaFloat3* step;
        public SoaFloat3x3* band;
        public SoaFloat3x3* lower;

        // Frames.
        public SoaQuaternion* boneRotations;

        /// <summary>[bone] Unit vector along the bone.</summary>
        public SoaFloat3* boneAxes;
        public SoaFloat3* rollFrom;
        public SoaFloat3* rollTo;
        public JointPose* pose;

        /// <summary>[joint] Velocity of the joint and force of the air that are read: those of the end of the substep.</summary>
        public SoaFloat3* endVelocities, endLoads;

        /// <summary>State and patch loads of wings that wait while others of their pack take more substeps.</summary>
        public float4* waiting;
        public float4* waitingLoads;

        /// <summary>Lays the arrays out one behind the other; with <paramref name="memory"/> null it only measures.</summary>
        /// <returns>Bytes needed.</returns>
        public static long Layout(in RigSize size, byte* memory, out StepScratch scratch)
        {
            int joints = size.joints, bones = size.bones, patches = size.patches;
            var carver = new BlockCarver(memory);
            scratch.means = (StrokeMeans*)carver.Carve<StrokeMeans>(1);
            scratch.localPhase = (float4*)carver.Carve<float4>(bones);
            scratch.amplitude = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            scratch.amplitudeRate = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            scratch.amplitudeCurvature = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            scratch.angle = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            scratch.angleRate = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            scratch.angleCurvature = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            scratch.flapSin = (float4*)carver.Carve<float4>(bones);
            scratch.flapCos = (float4*)carver.Carve<float4>(bones);
            scratch.drivenRotations = (SoaQuaternion*)carver.Carve<SoaQuaternion>(bones);
            scratch.angularVelocity = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            scratch.angularAcceleration = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            scratch.drivenPositions = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.drivenVelocities = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.drivenAccelerations = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.turns = (SoaQuaternion*)carver.Carve<SoaQuaternion>(bones);
            scratch.deformations = (SoaQuaternion*)carver.Carve<SoaQuaternion>(joints);
            scratch.carriedFrames = (SoaFloat3x3*)carver.Carve<SoaFloat3x3>(joints);
            scratch.carriedPositions = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.carriedTurning = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.carriedSpans = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.alongEdges = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.acrossEdges = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.hingeVelocities = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.spanRates = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.chordRates = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.forces = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.airForces = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.airDamping = (float4*)carver.Carve<float4>(joints);
            scratch.relativeWind = (SoaFloat3*)carver.Carve<SoaFloat3>(patches);
            scratch.normals = (SoaFloat3*)carver.Carve<SoaFloat3>(patches);
            scratch.alongSpan = (float4*)carver.Carve<float4>(patches);
            scratch.halfDensityAreas = (float4*)carver.Carve<float4>(patches);
            scratch.streams = (PatchStream*)carver.Carve<PatchStream>(patches);
            scratch.loads = (PatchLoad*)carver.Carve<PatchLoad>(patches);
            scratch.arms = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.compliances = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            scratch.coupledAngles = (float4*)carver.Carve<float4>(bones);
            scratch.stripCompliances = (float4*)carver.Carve<float4>(size.strips);
            scratch.stripYields = (float4*)carver.Carve<float4>(size.strips);
            scratch.stripForces = (float4*)carver.Carve<float4>(size.strips);
            scratch.torques = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            scratch.targets = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.anchors = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.inertia = (float4*)carver.Carve<float4>(joints);
            scratch.positions = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.candidate = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.mixing = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.gradient = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.blocks = (SymmetricBlock*)carver.Carve<SymmetricBlock>(joints);
            scratch.step = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.band = (SoaFloat3x3*)carver.Carve<SoaFloat3x3>(size.bandBlocks);
            scratch.lower = (SoaFloat3x3*)carver.Carve<SoaFloat3x3>(size.bandBlocks);
            scratch.boneRotations = (SoaQuaternion*)carver.Carve<SoaQuaternion>(bones);
            scratch.boneAxes = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            scratch.rollFrom = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            scratch.rollTo = (SoaFloat3*)carver.Carve<SoaFloat3>(bones);
            scratch.pose = (JointPose*)carver.Carve<JointPose>(joints);
            scratch.endVelocities = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            scratch.endLoads = (SoaFloat3*)carver.Carve<SoaFloat3>(joints);
            // A chain has at least two joints.
            scratch.waiting = (float4*)carver.Carve<float4>(PackMemory.StateCount(joints, bones, joints));
            scratch.waitingLoads = (float4*)carver.Carve<float4>(
                (patches * sizeof(PatchLoad) + joints * sizeof(SoaFloat3)) / sizeof(float4));
            return carver.Size;
        }
    }
}
