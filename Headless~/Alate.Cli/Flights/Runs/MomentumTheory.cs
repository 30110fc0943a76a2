namespace Alate.Cli;

/// <summary>
/// Speed of the air that a beating wing draws along, as an actuator disc of momentum theory (Rankine 1865, Froude 1889): even and steady.
/// In forward flight by Glauert's hypothesis (1926): the force is what the stream through the disc gains in momentum, T = 2ρ · w · |flow|.
/// What blows through the disc passes the sectors that the wings sweep; what blows along it passes the circle of the span, as behind a wing
/// (Prandtl 1918; for flapping wings Pennycuick 1968).
/// </summary>
internal static class MomentumTheory
{
    private const int k_Halvings = 80;

    /// <summary>Speed at the disc in hover, m/s: √(T / 2ρA).</summary>
    /// <param name="force">T, newtons, at least 0.</param>
    /// <param name="density">ρ, kg/m³, above 0.</param>
    /// <param name="area">A, m², above 0.</param>
    public static double Hover(double force, double density, double area) => Math.Sqrt(force / (2 * density * area));

    /// <summary>Speed at the disc in flight, m/s.</summary>
    /// <param name="force">T, newtons, at least 0.</param>
    /// <param name="density">ρ, kg/m³, above 0.</param>
    /// <param name="swept">Area that the wings sweep, m², above 0.</param>
    /// <param name="circle">Area of the circle of the span, m².</param>
    /// <param name="along">Part of the stream far ahead in the direction of the wake, m/s: above 0 where the insect climbs.</param>
    /// <param name="across">Part of the stream in the disc, m/s.</param>
    public static double InFlight(double force, double density, double swept, double circle, double along, double across)
    {
        double wide = across * circle / swept;
        return Speed(Hover(force, density, swept), Math.Sqrt(along * along + wide * wide), along);
    }

    /// <summary>
    /// Speed at the disc in a stream, m/s: the root of w² (V² + 2 w Vₙ + w²) = w₀⁴, which falls as the stream gets faster. Where a stream
    /// that comes against the wake has several roots, the least, as for a windmill.
    /// </summary>
    /// <param name="hover">w₀: speed in hover, m/s, at least 0.</param>
    /// <param name="stream">V: speed of the air far ahead against the wings' hinges, m/s, at least 0.</param>
    /// <param name="along">Vₙ: its part in the direction of the wake, m/s: above 0 where the insect climbs; in size at most V.</param>
    public static double Speed(double hover, double stream, double along)
    {
        double wanted = Math.Pow(hover, 4), low = 0, high = hover + Math.Max(-along, 0);
        double Excess(double w) => w * w * (stream * stream + 2 * w * along + w * w) - wanted;

        // Against the wake the left side rises to a hill, where it may pass the right one, before it rises for good.
        double discriminant = 9 * along * along - 8 * stream * stream;
        double hill = discriminant >= 0 ? (-3 * along - Math.Sqrt(discriminant)) / 4 : 0;
        if (hill > 0 && Excess(hill) >= 0)
            high = hill;
        for (int k = 0; k < k_Halvings; k++)
        {
            double middle = 0.5 * (low + high);
            (low, high) = Excess(middle) < 0 ? (middle, high) : (low, middle);
        }

        return 0.5 * (low + high);
    }
}
