namespace Alate.Flight
{
    /// <summary>Reasons why an insect does not fly.</summary>
    public enum FlightProblem
    {
        /// <summary>No problem: the insect flies, or waits for its wings.</summary>
        None,

        /// <summary>No trims: the insect has no trim table.</summary>
        NoTrims,

        /// <summary>The trims were made for other numbers of the preset or the body.</summary>
        OtherNumbers,

        /// <summary>Masses or parts of the body are not possible.</summary>
        BadBody,
    }
}
