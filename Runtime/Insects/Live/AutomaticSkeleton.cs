using System;
using UnityEngine;

namespace Alate
{
    /// <summary>The skeleton of a wing that was given none.</summary>
    internal static class AutomaticSkeleton
    {
        /// <summary>Lays out chains on a wing; the caller destroys the skeleton.</summary>
        /// <exception cref="ArgumentException">There is no way to lay one out; says why.</exception>
        public static WingSkeleton Fit(in WingSurface surface, WingSide side) =>
            throw new ArgumentException("Automatic layout is not available.");
    }
}
