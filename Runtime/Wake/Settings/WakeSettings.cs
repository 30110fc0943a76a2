using System;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Numbers of a free wake. Lengths are reference lengths, such as the length of the longest wing; times are beats; chords are the
    /// mean chord of each wing.
    /// </summary>
    public sealed class WakeSettings
    {
        /// <summary>Most rings on the wings: their matrix has the square of it.</summary>
        public const int MostRings = 2000;

        /// <summary>Most vertices of a wake.</summary>
        public const int MostVertices = 4_000_000;

        /// <summary>Settings with the defaults of a method.</summary>
        public WakeSettings(WakeMethod method = WakeMethod.Strips)
        {
            Method = method;
            ChordPanels = method == WakeMethod.Panels ? 4 : 1;
            NearCore = method == WakeMethod.Panels ? 0.05f : 0.25f;
            FarCore = method == WakeMethod.Panels ? 0.4f : 0.6f;
        }

        /// <summary>The way to find the circulation.</summary>
        public WakeMethod Method { get; }

        /// <summary>Panels along the chord, 1 to 64; strips have one. 4: within 3 % of 8 × 14 panels.</summary>
        public int ChordPanels { get; set; }

        /// <summary>Panels or strips along the span, 1 to 256.</summary>
        public int SpanPanels { get; set; } = 10;

        /// <summary>Steps a beat, 4 to 1000. From 24 to 48 the lift changes by 1.5 %.</summary>
        public int StepsPerBeat { get; set; } = 24;

        /// <summary>Age at which a row of the wake is dropped, beats, above 0 to 1000. With 2 the lift is 0.5 % low, with 1 2 %.</summary>
        public float Keep { get; set; } = 2f;

        /// <summary>Radius of the core of a vortex as it is shed, chords, above 0 to 10.</summary>
        public float NearCore { get; set; }

        /// <summary>Radius of an old core, chords, that of a new one to 10: keeps the wake smooth.</summary>
        public float FarCore { get; set; }

        /// <summary>Time in which a core grows from the first to the second, beats, above 0.</summary>
        public float CoreRamp { get; set; } = 0.3f;

        /// <summary>
        /// Core of the vortices bound to a wing as the wake, other wings and mirror images feel them, chords, above 0 to 10.
        /// </summary>
        public float BoundCore { get; set; } = 0.1f;

        /// <summary>Distance of the last row of rings behind the trailing edge, as a share of the edge's path in a step, 0 to 1.</summary>
        public float TrailingShare { get; set; } = 0.25f;

        /// <summary>
        /// Share of the leading edge's suction that turns into the normal, 0 to 1; for panels. 0.5 suits a revolving wing.
        /// </summary>
        public float TurnedSuction { get; set; } = 0.5f;

        /// <summary>
        /// Leaves the suction of panels along the chord, as attached flow at small angles has it, in place of turning it.
        /// </summary>
        public bool SuctionAlongChord { get; set; }

        /// <summary>Kinematic viscosity, squared reference lengths a beat, at least 0: cores grow with it.</summary>
        public float Viscosity { get; set; }

        /// <summary>Velocity of the air against the body, reference lengths a beat.</summary>
        public float3 Stream { get; set; }

        /// <summary>
        /// Sets cores as wide as a chord, old ones two. Where wings beat on and on in their own wake, as those of butterflies that hover,
        /// rings of slender cores throw one another about, another way in each beat; with these the wake repeats. Where slender ones do
        /// too, the lift is up to 5 % higher with these.
        /// </summary>
        public void WidenCores()
        {
            NearCore = BoundCore = 1f;
            FarCore = 2f;
        }

        /// <summary>Mirrors the wings, which are right ones, at x = 0.</summary>
        public bool Symmetric { get; set; }

        /// <summary>Height of the origin above a ground, reference lengths, above 0; infinite where there is none.</summary>
        public float GroundHeight { get; set; } = float.PositiveInfinity;

        /// <summary>Unit normal of the ground, in axes of the body.</summary>
        public float3 Up { get; set; } = new float3(0f, 1f, 0f);

        /// <summary>
        /// Computes on the thread that steps the wake, without jobs: for a wake beside the thread that schedules them.
        /// </summary>
        internal bool OnOneThread { get; set; }

        internal MirrorImages Images => new MirrorImages(Symmetric, math.isfinite(GroundHeight), Up, GroundHeight);

        internal float Step => 1f / StepsPerBeat;

        /// <summary>Rows of wake points that a wing keeps at most.</summary>
        internal int Rows => (int)math.ceil(Keep * StepsPerBeat) + 1;

        /// <summary>Makes settings with the same numbers.</summary>
        internal WakeSettings Copy() => (WakeSettings)MemberwiseClone();

        /// <summary>Checks the numbers for a number of wings.</summary>
        /// <exception cref="ArgumentException">One is out of its range; names it, its value and the range.</exception>
        internal void Validate(int wings)
        {
            Check(ChordPanels >= 1 && ChordPanels <= 64, nameof(ChordPanels), ChordPanels, "1 to 64");
            Check(Method == WakeMethod.Panels || ChordPanels == 1, nameof(ChordPanels), ChordPanels, "1 for strips");
            Check(SpanPanels >= 1 && SpanPanels <= 256, nameof(SpanPanels), SpanPanels, "1 to 256");
            Check(StepsPerBeat >= 4 && StepsPerBeat <= 1000, nameof(StepsPerBeat), StepsPerBeat, "4 to 1000");
            Check(Keep > 0f && Keep <= 1000f, nameof(Keep), Keep, "above 0, at most 1000 beats");
            Check(NearCore > 0f && NearCore <= 10f, nameof(NearCore), NearCore, "above 0, at most 10 chords");
            Check(FarCore >= NearCore && FarCore <= 10f, nameof(FarCore), FarCore, "NearCore to 10 chords");
            Check(CoreRamp > 0f && math.isfinite(CoreRamp), nameof(CoreRamp), CoreRamp, "above 0 beats");
            Check(BoundCore > 0f && BoundCore <= 10f, nameof(BoundCore), BoundCore, "above 0, at most 10 chords");
            Check(TrailingShare >= 0f && TrailingShare <= 1f, nameof(TrailingShare), TrailingShare, "0 to 1");
            Check(TurnedSuction >= 0f && TurnedSuction <= 1f, nameof(TurnedSuction), TurnedSuction, "0 to 1");
            Check(Viscosity >= 0f && math.isfinite(Viscosity), nameof(Viscosity), Viscosity, "at least 0");
            Check(math.all(math.isfinite(Stream)), nameof(Stream), Stream, "finite");
            Check(!float.IsNaN(GroundHeight) && GroundHeight > 0f, nameof(GroundHeight), GroundHeight, "above 0");
            Check(math.abs(math.length(Up) - 1f) < 1e-3f, nameof(Up), Up, "a unit vector");
            Check(wings >= 1, "wings", wings, "1 or more");
            int rings = wings * ChordPanels * SpanPanels;
            Check(rings <= MostRings, "rings of all wings", rings, $"at most {MostRings}");
            long vertices = (long)wings * (2L * Rows * (SpanPanels + 1));
            Check(
                vertices <= MostVertices, "vertices of the wake", vertices,
                $"at most {MostVertices}: fewer steps, panels or beats to keep");
        }

        private static void Check(bool holds, string name, object value, string allowed)
        {
            if (!holds)
                throw new ArgumentException(FormattableString.Invariant($"{name} is {value}; allowed: {allowed}."));
        }
    }
}
