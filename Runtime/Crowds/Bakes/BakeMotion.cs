using System;
using System.Collections.Generic;
using Alate.Flight;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>
    /// A steady motion of an insect that is baked as a loop: how fast the body goes, how it lies, and how the beat differs from the
    /// preset's.
    /// </summary>
    public sealed class BakeMotion
    {
        private static readonly BakeMotion[] s_All =
        {
            new BakeMotion("cruise") { Speed = 0.65f, IsFlown = true },
            new BakeMotion("hover") { Steering = Beat(1.15f, 0f), IsFlown = true },
            new BakeMotion("climb") { Speed = 0.4f, Climb = 0.25f, PitchDegrees = 20f, Steering = Beat(1.1f, 0f), IsFlown = true },
            new BakeMotion("turn-left") { Speed = 0.5f, Roll = -0.15f, TurnDegrees = -60f, IsFlown = true },
            new BakeMotion("turn-right") { Speed = 0.5f, Roll = 0.15f, TurnDegrees = 60f, IsFlown = true },
            new BakeMotion("glide") { Speed = 0.65f, Steering = Beat(0f, 8f) },
            new BakeMotion("rest") { Steering = Beat(0f, 0f) },
            new BakeMotion("folded") { Steering = Folded(1f) },
            new BakeMotion("bask") { Steering = Folded(1f - PerchSettings.Default.bask) },
        };

        /// <summary>A level motion without speed, with the preset's beat.</summary>
        /// <param name="name">Lower case, words joined by hyphens.</param>
        /// <exception cref="ArgumentException">The name is empty.</exception>
        public BakeMotion(string name)
        {
            if (string.IsNullOrWhiteSpace(name))
                throw new ArgumentException("A motion needs a name.", nameof(name));
            Name = name;
        }

        /// <summary>The motions that come with the package.</summary>
        public static IReadOnlyList<BakeMotion> All => s_All;

        /// <summary>The names of <see cref="All"/>.</summary>
        public static IReadOnlyList<string> Names { get; } = Array.ConvertAll(s_All, motion => motion.Name);

        /// <summary>Name of the clip.</summary>
        public string Name { get; }

        /// <summary>
        /// True where an insect with an <see cref="Alate.Flight.InsectFlight"/> flies it freely by its trims: its speeds are then shares of
        /// the table's top speed, its attitude and beat are those that carry the insect. Otherwise, and without that component, the body is
        /// held and the air meets it.
        /// </summary>
        public bool IsFlown { get; set; }

        /// <summary>Turn to the right where the motion is flown, degrees a second, −180 to 180; 0.</summary>
        public float TurnDegrees { get; set; }

        /// <summary>Speed ahead over the preset's top speed, −1 to 1; 0.</summary>
        public float Speed { get; set; }

        /// <summary>Speed up over the preset's top speed, −1 to 1; 0.</summary>
        public float Climb { get; set; }

        /// <summary>Pitch of the body, degrees, nose up positive, −90 to 90; 0.</summary>
        public float PitchDegrees { get; set; }

        /// <summary>
        /// Difference of the amplitudes of both sides over their sum, −1 to 1, 0; positive beats the left side harder, which rolls to the
        /// right.
        /// </summary>
        public float Roll { get; set; }

        /// <summary>Differences of the beat from the preset's, in place of the insect's own steering.</summary>
        public InsectSteering Steering { get; set; } = InsectSteering.Default;

        /// <summary>Finds a motion of <see cref="All"/> by its name.</summary>
        /// <exception cref="ArgumentException">There is none; the message lists those there are.</exception>
        public static BakeMotion Find(string name)
        {
            BakeMotion found = Array.Find(s_All, motion => string.Equals(motion.Name, name, StringComparison.OrdinalIgnoreCase));
            return found ?? throw new ArgumentException($"There is no clip '{name}'. Known: {string.Join(", ", Names)}.");
        }

        /// <summary>The first thing that is out of its range; null when all is well.</summary>
        internal string FindProblem()
        {
            if (!(math.abs(Speed) <= 1f) || !(math.abs(Climb) <= 1f))
                return $"Clip '{Name}': speeds must lie between -1 and 1 of the top speed, not {Speed} ahead and {Climb} up.";
            if (!(math.abs(PitchDegrees) <= 90f))
                return $"Clip '{Name}': the pitch must lie between -90 and 90 degrees, not {PitchDegrees}.";
            if (!(math.abs(TurnDegrees) <= 180f))
                return $"Clip '{Name}': the turn must lie between -180 and 180 degrees a second, not {TurnDegrees}.";
            return math.abs(Roll) <= 1f ? null : $"Clip '{Name}': the roll must lie between -1 and 1, not {Roll}.";
        }

        /// <summary>Speed of the body, m/s.</summary>
        /// <param name="maxSpeed">Top speed of the preset, m/s.</param>
        internal float SpeedOf(float maxSpeed) => maxSpeed * math.length(new float2(Speed, Climb));

        /// <summary>Motion of the body and the air around it, in the insect's own space.</summary>
        /// <param name="maxSpeed">Top speed of the preset, m/s.</param>
        /// <param name="toldMetresPerUnit">What the insect is told; 0 takes each wing's own size for life size.</param>
        /// <param name="metresPerUnit">Metres of a unit of the insect's space.</param>
        internal BodyFlight FlightOf(float maxSpeed, float toldMetresPerUnit, float metresPerUnit)
        {
            float pitch = math.radians(PitchDegrees);
            return new BodyFlight
            {
                velocity = ToBody(new float3(0f, Climb, Speed) * maxSpeed, pitch) / metresPerUnit,
                gravity = ToBody(EarthGravity.Down, pitch),
                forward = new float3(0f, 0f, 1f),
                metresPerUnit = toldMetresPerUnit,
            };
        }

        /// <summary>Changes the parameters of a wing.</summary>
        internal void Apply(WingSide side, ref WingParameters parameters)
        {
            Steering.Clamped().Apply(ref parameters);
            parameters.amplitudeScale *= side == WingSide.Left ? 1f + Roll : 1f - Roll;
        }

        private static InsectSteering Folded(float share) => new InsectSteering { frequencyScale = 1f, fold = share };

        private static InsectSteering Beat(float amplitude, float meanFlap) =>
            new InsectSteering { frequencyScale = 1f, amplitudeScale = amplitude, meanFlap = meanFlap };

        private static float3 ToBody(float3 world, float pitch)
        {
            Elementary.SinCos(pitch, out float sine, out float cosine);
            return new float3(world.x, cosine * world.y - sine * world.z, sine * world.y + cosine * world.z);
        }
    }
}
