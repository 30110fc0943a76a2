namespace Alate.Editor
{
    /// <summary>Sample of an insect's beat at one time.</summary>
    internal readonly struct BeatSample
    {
        /// <summary>Number of beats of the first wing since its start, with the share of the current one.</summary>
        public readonly double beat;

        /// <summary>Flap angle of the first wing's tip, degrees above its wing plane at rest; see <see cref="BeatReader"/>.</summary>
        public readonly float flap;

        /// <summary>Lift of all wings over the insect's weight.</summary>
        public readonly float lift;

        public BeatSample(double beat, float flap, float lift)
        {
            this.beat = beat;
            this.flap = flap;
            this.lift = lift;
        }

        /// <summary>Share of the current beat, [0, 1).</summary>
        public float Phase => (float)(beat - System.Math.Floor(beat));
    }
}
