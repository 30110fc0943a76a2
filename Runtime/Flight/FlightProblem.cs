namespace Alate.Flight
{
    /// <summary>Why an insect does not fly.</summary>
    public enum FlightProblem
    {
        /// <summary>It flies, or waits for its wings.</summary>
        None,

        /// <summary>There are no trims.</summary>
        NoTrims,

        /// <summary>The trims were made for other numbers of the preset or the body.</summary>
        OtherNumbers,

        /// <summary>Masses or parts of the body are not possible.</summary>
        BadBody,
    }
}
