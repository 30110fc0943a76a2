namespace Alate.Cli.Pictures;

/// <summary>A see-through part of a surface: it is painted as one, so that its own pieces do not shine through each other where their edges meet.</summary>
/// <param name="Surface">Which surface; 0 for all that is solid.</param>
/// <param name="Percent">How much of what lies behind is seen, 0 to 99.</param>
internal readonly record struct Glass(int Surface, int Percent)
{
    public bool IsSolid => Percent == 0;

    /// <summary>Of a surface with an opacity, in steps of so many per cent.</summary>
    public static Glass Of(int surface, float opacity, int step)
    {
        int percent = step * (int)System.MathF.Round(100f * (1f - opacity) / step);
        return percent <= 0 ? default : new Glass(surface, System.Math.Min(percent, 100 - step));
    }
}
