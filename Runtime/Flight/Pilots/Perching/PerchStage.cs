namespace Alate.Flight
{
    /// <summary>What an insect that lands now and then does.</summary>
    public enum PerchStage
    {
        /// <summary>Another pilot flies.</summary>
        Between,

        /// <summary>On the way to a place before the spot.</summary>
        Approaching,

        /// <summary>The last way down to the spot, slower and slower.</summary>
        Flaring,

        /// <summary>The insect sits.</summary>
        Perched,

        /// <summary>Away from the spot, forward and up.</summary>
        TakingOff,
    }
}
