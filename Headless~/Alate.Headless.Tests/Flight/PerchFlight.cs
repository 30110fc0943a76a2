namespace Alate.Tests.Flight
{
    /// <summary>Result of one landing and the start after it. Metres, seconds.</summary>
    internal sealed class PerchFlight
    {
        public bool Landed { get; set; }
        public bool Tumbled { get; set; }

        /// <summary>Speed of the centre of mass where it is held, and of the reference.</summary>
        public float HeldSpeed { get; set; }
        public float MeanSpeed { get; set; }

        /// <summary>Height of the feet over where they should be held, a wing's clearance above the spot, and distance beside it.</summary>
        public float Gap { get; set; }
        public float Beside { get; set; }

        public float Seconds { get; set; }
        public int Attempts { get; set; }

        /// <summary>Lowest height of the centre of mass over the spot on the way down.</summary>
        public float Lowest { get; set; } = float.PositiveInfinity;

        /// <summary>Lowest height of the centre of mass over the surface on the way down.</summary>
        public float Below { get; set; } = float.PositiveInfinity;

        /// <summary>Lowest height of the centre of mass over the surface after the start, and distance from the spot at its end.</summary>
        public float LeastHeight { get; set; }
        public float LeftBehind { get; set; }
    }
}
