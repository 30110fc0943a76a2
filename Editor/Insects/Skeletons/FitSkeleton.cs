using Alate.Fitting;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Lays out chains on a wing.</summary>
    /// <param name="surface">The wing, mesh space.</param>
    /// <param name="insect">The insect's root.</param>
    /// <param name="mesh">What draws the wing.</param>
    /// <exception cref="System.ArgumentException">There is no way to lay them out; says why in one line.</exception>
    internal delegate SkeletonFit FitSkeleton(SurfaceMesh surface, Transform insect, Transform mesh);
}
