using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Numbers of four wings that the kernels read as they are given; lane = wing. What is computed from them is in
    /// <see cref="LaneParameters"/>.
    /// </summary>
    /// <remarks>
    /// 76 bytes a wing: one float4 a number, so that four wings with different parameters run through one kernel.
    /// </remarks>
    internal struct NumberLanes
    {
        public float4 maxFrequency;
        public float4 maxSpeed;
        public float4 frequencyFloor;
        public float4 amplitudeFloor;
        public float4 meanFlap;
        public float4 rootShare;
        public float4 inertia;
        public float4 airDensity;
        public float4 stiffnessRoot;
        public float4 stiffnessTip;
        public float4 stiffnessDecay;
        public float4 bendDamping;
        public float4 dorsalAsymmetry;
        public float4 stiffnessUnit;
        public float4 inPlaneFactor;
        public float4 torsionFactor;
        public float4 jointLimit;
        public float4 springDamping;
        public float4 substepsPerBeat;

        /// <summary>Writes one wing's numbers.</summary>
        public void Set(int lane, in WingParameters p)
        {
            maxFrequency[lane] = p.maxFrequency;
            maxSpeed[lane] = p.maxSpeed;
            frequencyFloor[lane] = p.frequencyFloor;
            amplitudeFloor[lane] = p.amplitudeFloor;
            meanFlap[lane] = p.meanFlap;
            rootShare[lane] = p.rootShare;
            inertia[lane] = p.inertia;
            airDensity[lane] = p.airDensity;
            stiffnessRoot[lane] = p.stiffnessRoot;
            stiffnessTip[lane] = p.stiffnessTip;
            stiffnessDecay[lane] = p.stiffnessDecay;
            bendDamping[lane] = p.bendDamping;
            dorsalAsymmetry[lane] = p.dorsalAsymmetry;
            stiffnessUnit[lane] = p.stiffnessUnit;
            inPlaneFactor[lane] = p.inPlaneFactor;
            torsionFactor[lane] = p.torsionFactor;
            jointLimit[lane] = p.jointLimit;
            springDamping[lane] = p.springDamping;
            substepsPerBeat[lane] = p.substepsPerBeat;
        }
    }
}
