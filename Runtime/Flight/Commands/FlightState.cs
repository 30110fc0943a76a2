namespace Alate.Flight
{
    /// <summary>State of an insect that flies by its own wings.</summary>
    public enum FlightState
    {
        /// <summary>The wings carry the insect where its pilot asks.</summary>
        Flying,

        /// <summary>The body is more than 70° off the attitude that it should have; the wings turn it back.</summary>
        Tumbling,

        /// <summary>The insect approaches the spot on which it is to perch, or glides down to it.</summary>
        Landing,

        /// <summary>The insect sits; its wings carry nothing.</summary>
        Perched,
    }
}
