using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Radii of vortex cores of a wing's wake: they widen from that of the shed vortex to that of the far wake, and by viscosity,
    /// molecular and turbulent (Squire 1965).
    /// </summary>
    internal readonly struct WakeCores
    {
        /// <summary>Of Lamb and Oseen's vortex: the velocity is largest where r² = 4 · 1.25643 ν t.</summary>
        private const float k_Lamb = 1.25643f;

        /// <summary>Turbulent viscosity over circulation (Bhagwat and Leishman 2002 have 1e-4 to 2e-4 for small rotors).</summary>
        private const float k_Turbulence = 1e-4f;

        private readonly float m_Near, m_Far, m_Ramp, m_Viscosity;

        public WakeCores(WakeSettings settings, float chord)
        {
            m_Near = settings.NearCore * chord;
            m_Far = settings.FarCore * chord;
            m_Ramp = settings.CoreRamp;
            m_Viscosity = settings.Viscosity;
            Bound = settings.BoundCore * chord;
            Bound *= Bound;
        }

        /// <summary>Square of the core of bound vortices, as others feel them.</summary>
        public float Bound { get; }

        /// <summary>Square of the core of a vortex as it is shed, and of the bound one at the trailing edge, which lies on it.</summary>
        public float Shed => m_Near * m_Near;

        /// <summary>Square of the core of a segment of the wake.</summary>
        /// <param name="age">Beats since it was shed.</param>
        /// <param name="circulation">Size of the larger circulation of the two rings at it.</param>
        public float Of(float age, float circulation)
        {
            float radius = math.lerp(m_Near, m_Far, math.min(1f, age / m_Ramp));
            return radius * radius + 4f * k_Lamb * (m_Viscosity + k_Turbulence * circulation) * age;
        }
    }
}
