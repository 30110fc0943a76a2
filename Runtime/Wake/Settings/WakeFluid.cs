namespace Alate.Wake
{
    /// <summary>Viscosities of the fluids that insects beat in.</summary>
    internal static class WakeFluid
    {
        /// <summary>Kinematic viscosities at 20 °C, m²/s, and the density that parts liquids from gases, kg/m³.</summary>
        private const float k_AirViscosity = 1.5e-5f, k_WaterViscosity = 1.0e-6f, k_Liquid = 100f;

        /// <summary>Kinematic viscosity of air or water at 20 °C, m²/s.</summary>
        /// <param name="density">Of the fluid, kg/m³.</param>
        public static float ViscosityOf(float density) => density > k_Liquid ? k_WaterViscosity : k_AirViscosity;
    }
}
