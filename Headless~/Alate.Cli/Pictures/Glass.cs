namespace Alate.Cli.Pictures;

/// <summary>A see-through part of a surface: it is painted as one, so that its own pieces do not shine through each other where their edges meet.</summary>
/// <param name="Surface">Which surface; 0 for all that is solid.</param>
/// <param name="Percent">How much of what lies behind is seen, 0 to 99.</param>
internal readonly record struct Glass(int Surface, int Percent)
{
    private const int k_Step = 10;

    public bool IsSolid => Percent == 0;

    /// <summary>Of a surface with an opacity, in a few steps.</summary>
    public static Glass Of(int surface, float opacity)
    {
        int percent = k_Step * (int)System.MathF.Round(100f * (1f - opacity) / k_Step);
        return percent <= 0 ? default : new Glass(surface, System.Math.Min(percent, 100 - k_Step));
    }
}
