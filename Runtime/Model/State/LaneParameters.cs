using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Live parameters of four wings, as the kernels read them; lane = wing. A moved slider rewrites only these.</summary>
    /// <remarks>
    /// 200 bytes a wing: the numbers as given first, then what is computed from them, once a change instead of once a substep.
    /// </remarks>
    internal struct LaneParameters
    {
        /// <summary>Least half amplitude by which the speed of the tip is measured where a wing hardly flaps: 6°.</summary>
        private const float k_LeastAmplitude = 0.1f;

        /// <summary>
        /// Elasticity k_e below which a wing gets softer to bend but no easier to stretch: a thin membrane hardly stretches, however limp
        /// the wing is. With 1, the fishfly's edges stretch by 5 % in a gale instead of 3 %.
        /// </summary>
        private const float k_LeastMembrane = 2f;

        /// <summary>
        /// Stiffness of springs against turning out of their posed directions, over k_e κ (2π f_ref)². Springs alone let a sheet of joints
        /// fold without resistance, and a narrow strip that snapped over in a gust would stay so; twice as much lets the drive's own shear
        /// stretch the narrow wings by a third more.
        /// </summary>
        private const float k_FoldShare = 0.01f;

        /// <summary>
        /// Elasticity k_e below which a wing gets no easier to fold: with less, wings at a tenth of their elasticity fold over strip by
        /// strip.
        /// </summary>
        private const float k_LeastFold = 0.5f;

        /// <summary>Numbers that the kernels read as they are given.</summary>
        public NumberLanes numbers;
        public SoaFloat3 amplitude;
        public SoaFloat3 phaseSin;
        public SoaFloat3 phaseCos;

        public float4 tilt;

        /// <summary>Amplitude of the flap as in the preset, whatever the steering makes of it, radians.</summary>
        public float4 wholeFlap;

        /// <summary>λπ: delay of the last chain, radians.</summary>
        public float4 chordDelay;

        /// <summary>Delay μπ of the last joint, radians.</summary>
        public float4 spanDelay;

        /// <summary>Delay of the whole wing, radians: 2π less its phase lead.</summary>
        public float4 wingDelay;


        /// <summary>Speed of the air above which the wing hardly bends more, L/s.</summary>
        public float4 strongestWind;

        /// <summary>k_e (2π f_ref)², s⁻²: times a joint's inertia and N² it is the bending stiffness.</summary>
        public float4 bendScale;


        /// <summary>Roots of the three factors: what each multiplies a joint's damping by.</summary>
        public float4 dorsalDamping;
        public float4 inPlaneDamping;
        public float4 torsionDamping;

        /// <summary>k of Eq. 12, in wing masses per second squared.</summary>
        public float4 springStiffness;

        /// <summary>
        /// Stiffness of the same springs against turning out of their posed directions, in wing masses per second squared.
        /// </summary>
        public float4 foldStiffness;

        /// <summary>Ω, the rate at which a joint returns to its pose, rad/s.</summary>
        public float4 anchorRate;


        /// <summary>Frequency of a prescribed motion, hertz; 0 where none is prescribed.</summary>
        public float4 prescribedFrequency;

        /// <summary>1 where delays act on the prescribed angles, else 0.</summary>
        public float4 prescribedWaves;

        /// <summary>Commands of a flight controller; no parameter changes them.</summary>
        public LaneDrive drive;

        /// <summary>Strongest wind that bends a wing freely, L/s.</summary>
        public static float StrongestWindOf(in WingParameters p) =>
            p.strongestWind * 2f * math.PI * p.referenceFrequency * math.max(p.amplitude.x, k_LeastAmplitude);

        /// <summary>Writes one wing's parameters, which are in range.</summary>
        public void Set(int lane, in WingParameters p)
        {
            numbers.Set(lane, p);
            prescribedFrequency[lane] = p.kinematics.frequency;
            prescribedWaves[lane] = p.kinematics.waves ? 1f : 0f;
            amplitude[lane] = p.amplitude * p.amplitudeScale;
            wholeFlap[lane] = p.amplitude.x;
            Elementary.SinCos(p.phase, out float3 sin, out float3 cos);
            phaseSin[lane] = sin;
            phaseCos[lane] = cos;
            tilt[lane] = p.tilt;
            chordDelay[lane] = math.PI * p.chordDelay;
            spanDelay[lane] = math.PI * p.spanDelay;
            float lead = p.phaseLead / (2f * math.PI);
            wingDelay[lane] = 2f * math.PI * (math.ceil(lead) - lead);
            strongestWind[lane] = StrongestWindOf(p);

            float beatRate = 2f * math.PI * p.referenceFrequency;
            bendScale[lane] = p.elasticity * beatRate * beatRate;
            dorsalDamping[lane] = math.sqrt(p.dorsalAsymmetry);
            inPlaneDamping[lane] = math.sqrt(p.inPlaneFactor);
            torsionDamping[lane] = math.sqrt(p.torsionFactor);
            bool twoWay = p.options.coupling == MembraneCoupling.TwoWay;
            float springUnit = p.options.springUnits == SpringUnits.Printed ? 1f : p.springScale * beatRate * beatRate;
            springStiffness[lane] = springUnit * (twoWay ? math.max(p.elasticity, k_LeastMembrane) : p.elasticity);
            foldStiffness[lane] = twoWay ? k_FoldShare * math.max(p.elasticity, k_LeastFold) * springUnit : 0f;
            anchorRate[lane] = p.anchor * beatRate * math.sqrt(p.elasticity);
        }
    }
}
