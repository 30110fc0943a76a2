using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// The blend of a cell's four joint transforms as a bilinear function of (u, v), each component broadcast to four lanes:
    /// blend(u, v) = c + u·cu + v·(cv + u·cuv), which is the sum with weights (1−u)(1−v), (1−u)v, u(1−v), uv.
    /// </summary>
    internal struct CellBlend
    {
        public Coefficients8 c;
        public Coefficients8 cu;
        public Coefficients8 cv;
        public Coefficients8 cuv;

        /// <summary>Signs are aligned to the first joint of the cell, once for all its vertices.</summary>
        public CellBlend(in DualQuaternion at00, in DualQuaternion at01, in DualQuaternion at10, in DualQuaternion at11)
        {
            DualQuaternion a01 = at01.AlignedWith(at00), a10 = at10.AlignedWith(at00), a11 = at11.AlignedWith(at00);
            c = new Coefficients8(at00);
            cu = new Coefficients8(a10 - at00);
            cv = new Coefficients8(a01 - at00);
            cuv = new Coefficients8(a11 - a10 - (a01 - at00));
        }

        /// <summary>Eight components, each in all four lanes.</summary>
        internal struct Coefficients8
        {
            public SoaFloat3 real;
            public float4 realW;
            public SoaFloat3 dual;
            public float4 dualW;

            public Coefficients8(in DualQuaternion d)
            {
                real = new SoaFloat3(d.real.xyz);
                realW = d.real.w;
                dual = new SoaFloat3(d.dual.xyz);
                dualW = d.dual.w;
            }
        }
    }
}
