namespace Alate.Flight
{
    /// <summary>Stages of an insect that lands now and then.</summary>
    public enum PerchStage
    {
        /// <summary>Flight under another pilot.</summary>
        Between,

        /// <summary>Way to a place before the spot.</summary>
        Approaching,

        /// <summary>Last way down to the spot, slower and slower.</summary>
        Flaring,

        /// <summary>Stay on the spot.</summary>
        Perched,

        /// <summary>Way from the spot, forward and up.</summary>
        TakingOff,
    }
}
