using System;

namespace Alate.Wake
{
    /// <summary>Finds circulation and loads of all wings at a moment.</summary>
    internal interface IWingSolver : IDisposable
    {
        /// <summary>Solves for the circulation and computes the loads.</summary>
        /// <param name="wake">Holds the wake; takes the points of the wings.</param>
        /// <param name="steps">Number of steps before this one.</param>
        /// <returns>False where there is no solution; the circulation is 0 then.</returns>
        bool Solve(VortexField wake, int steps);
    }
}
