namespace Alate.Flight
{
    /// <summary>Why an insect does not fly.</summary>
    public enum FlightProblem
    {
        /// <summary>It flies, or waits for its wings.</summary>
        None,

        /// <summary>There are no Insect Wings on the object.</summary>
        NoWings,

        /// <summary>The trim table is missing, or was made for other numbers.</summary>
        NoTrims,

        /// <summary>Masses or parts of the body are not possible.</summary>
        BadBody,
    }
}
