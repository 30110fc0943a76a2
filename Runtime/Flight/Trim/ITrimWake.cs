namespace Alate.Flight
{
    /// <summary>Computes wakes behind beats that carry an insect, for <see cref="TrimBake"/>.</summary>
    public interface ITrimWake
    {
        /// <summary>Finds the air that the wake of a beat sets moving at the wings.</summary>
        /// <param name="model">The insect.</param>
        /// <param name="trim">Attitude, beat and bob, and the air that the wings meet so far.</param>
        /// <param name="condition">Of the trim.</param>
        /// <param name="pairs">
        /// [pair of wings] Filled with the air in the frame of a right wing, wing lengths per second. Pairs beyond the first two meet none.
        /// </param>
        /// <returns>False where the wake is another one in each beat; nothing is filled then.</returns>
        bool Find(FlightModel model, TrimState trim, in FlightCondition condition, WingInflow[] pairs);
    }
}
