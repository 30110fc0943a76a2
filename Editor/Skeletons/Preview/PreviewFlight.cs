using Unity.Mathematics;

namespace Alate.Editor
{
    /// <summary>Wing and level flight that a preview shows.</summary>
    internal readonly struct PreviewFlight
    {
        /// <summary>Speed as a share of the preset's u_max: a monarch's 1.3 m/s.</summary>
        private const float k_CruiseShare = 0.65f;

        public readonly WingParameters parameters;
        public readonly WingSurroundings surroundings;

        private PreviewFlight(in WingParameters parameters, in WingSurroundings surroundings)
        {
            this.parameters = parameters;
            this.surroundings = surroundings;
        }

        /// <summary>A preset's wing in level flight.</summary>
        public static PreviewFlight Of(PresetValues preset)
        {
            float speed = k_CruiseShare * preset.parameters.maxSpeed;
            return new PreviewFlight(preset.parameters, new WingSurroundings
            {
                wind = new float3(0f, 0f, -speed / preset.size.wingLength),
                gravity = new float3(0f, -EarthGravity.Size * preset.size.gravityShare / preset.size.wingLength, 0f),
                speed = speed,
            });
        }
    }
}
