using Unity.Mathematics;

namespace Alate
{
    /// <summary>Contribution of one spring to gradient and Hessian at the present positions.</summary>
    internal struct SpringLinearisation
    {
        /// <summary>Unit vector from joint b to joint a.</summary>
        public SoaFloat3 axis;

        /// <summary>Curvature along the axis beyond the transversal one.</summary>
        public float4 axial;

        /// <summary>Curvature across the axis, k(1 − L/l); negative while compressed.</summary>
        public float4 transversal;
    }
}
