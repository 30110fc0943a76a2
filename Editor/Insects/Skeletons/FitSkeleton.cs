namespace Alate.Editor
{
    /// <summary>Lays out chains on a wing.</summary>
    /// <exception cref="System.ArgumentException">There is no way to lay them out; says why in one line.</exception>
    internal delegate WingSkeleton FitSkeleton(in WingSurface surface, WingSide side);
}
