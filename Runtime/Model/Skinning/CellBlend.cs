using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Blend of a cell's four joint transforms as a bilinear function of (u, v), each component broadcast to four lanes: blend(u, v) = c +
    /// u·cu + v·(cv + u·cuv), which is the sum with weights (1−u)(1−v), (1−u)v, u(1−v), uv.
    /// </summary>
    internal struct CellBlend
    {
        public Coefficients8 c;
        public Coefficients8 cu;
        public Coefficients8 cv;
        public Coefficients8 cuv;

        /// <summary>
        /// Sets the transforms of the four joints; aligns their signs to the first joint of the cell, once for all its vertices.
        /// </summary>
        public void Set(in DualQuaternion at00, in DualQuaternion at01, in DualQuaternion at10, in DualQuaternion at11)
        {
            DualQuaternion a01 = at01.AlignedWith(at00), a10 = at10.AlignedWith(at00), a11 = at11.AlignedWith(at00);
            c.Set(at00.real, at00.dual);
            cu.Set(a10.real - at00.real, a10.dual - at00.dual);
            cv.Set(a01.real - at00.real, a01.dual - at00.dual);
            cuv.Set(a11.real - a10.real - (a01.real - at00.real), a11.dual - a10.dual - (a01.dual - at00.dual));
        }

        /// <summary>Eight components, each in all four lanes.</summary>
        internal struct Coefficients8
        {
            public SoaFloat3 real;
            public float4 realW;
            public SoaFloat3 dual;
            public float4 dualW;

            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            public void Set(float4 q, float4 e)
            {
                real.x = q.xxxx;
                real.y = q.yyyy;
                real.z = q.zzzz;
                realW = q.wwww;
                dual.x = e.xxxx;
                dual.y = e.yyyy;
                dual.z = e.zzzz;
                dualW = e.wwww;
            }
        }
    }
}
