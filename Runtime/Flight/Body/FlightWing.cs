using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>One wing of an insect that is to fly: its rig and parameters, and how it sits on the body.</summary>
    public sealed class FlightWing
    {
        /// <summary>The wing's rig, which must live while flights of it do.</summary>
        public WingRig Rig { get; set; }

        /// <summary>Mesh of the wing at rest, of which its rig was baked; null where nobody computes its wake.</summary>
        public SurfaceMesh Surface { get; set; }

        /// <summary>Parameters of the beat from which commands depart.</summary>
        public WingParameters Parameters { get; set; }

        /// <summary>The hinge from the middle of the thorax in body axes, metres.</summary>
        public float3 Hinge { get; set; }

        /// <summary>Directions of the wing's frame in body axes; a left wing's is a mirror.</summary>
        public float3x3 Axes { get; set; }

        /// <summary>Length, metres.</summary>
        public float Length { get; set; }

        /// <summary>Mass, kilograms.</summary>
        public float Mass { get; set; }

        /// <summary>Share of gravity that the wing feels, 0 to 1.</summary>
        public float GravityShare { get; set; } = 1f;

        /// <summary>True where it is a left wing, a right one's mirror image.</summary>
        public bool IsLeft { get; set; }
    }
}
