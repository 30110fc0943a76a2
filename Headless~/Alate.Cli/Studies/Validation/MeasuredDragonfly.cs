namespace Alate.Cli;

/// <summary>A published flight of a dragonfly: its conditions, the sizes of the insect, and the file with its kinematics.</summary>
/// <param name="Name">Name of its kinematics in the manual's folder.</param>
/// <param name="Speed">m/s ahead.</param>
/// <param name="Climb">m/s up.</param>
/// <param name="Mass">Of the insect, kg.</param>
/// <param name="Lengths">Of fore and hind wing, m.</param>
/// <param name="Areas">Of one fore and one hind wing, m².</param>
/// <param name="Source">Where it was published.</param>
internal sealed record MeasuredDragonfly(
    string Name, double Speed, double Climb, double Mass, double[] Lengths, double[] Areas, string Source)
{
    private const string k_Azuma = "Azuma and Watanabe 1988, J. exp. Biol. 137",
        k_Climb = "Azuma, Azuma, Watanabe and Furuta 1985, J. exp. Biol. 116",
        k_Wang = "Wang and Russell 2007, Phys. Rev. Lett. 99:148101";
    private static readonly double[] s_AzumaLengths = [0.0500, 0.0485], s_AzumaAreas = [500e-6, 600e-6];

    /// <summary>The three flights in a tunnel.</summary>
    public static IReadOnlyList<MeasuredDragonfly> Flights { get; } = [Flight(1, 0.7, -12), Flight(2, 1.5, -1.1), Flight(3, 2.3, 4.8)];

    /// <summary>The fourth flight, of another animal, whose mass and wings are not at hand: those of the first one.</summary>
    public static MeasuredDragonfly Fourth { get; } = Flight(4, 3.2, 0);

    /// <summary>A smaller dragonfly, <i>Sympetrum frequens</i>, that climbs at 60°.</summary>
    public static MeasuredDragonfly Climbing { get; } = new(
        "dragonfly-climb", 0.54 * Math.Cos(Math.PI / 3), 0.54 * Math.Sin(Math.PI / 3), 260e-6, [0.0335, 0.0325], [221e-6, 272e-6], k_Climb)
    {
        BodyLength = 0.040,
        HalfSpeed = 0.005,
        HalfAngle = 0.5,
    };

    /// <summary>The tethered insect.</summary>
    public static MeasuredDragonfly Tethered { get; } = new("dragonfly-tethered", 0, 0, 620e-6, [0.046, 0.043], [380e-6, 440e-6], k_Wang);

    /// <summary>
    /// Vertical force of all wings over the weight at t/T = 0, 0.02, …: two-dimensional Navier–Stokes and blade elements, mean of five
    /// beats.
    /// </summary>
    public static IReadOnlyList<double> TetheredForce { get; } =
    [
        -0.11, 0.00, 0.15, 0.24, 0.29, 0.37, 0.46, 0.65, 0.85, 0.92, 0.95, 1.25, 2.19,
        2.86, 2.95, 2.85, 2.81, 2.94, 2.99, 2.84, 2.56, 2.45, 2.34, 2.06, 1.67,
        1.31, 1.00, 0.78, 0.62, 0.54, 0.44, 0.33, 0.20, 0.02, -0.22, -0.36, -0.37, -0.30,
        -0.17, -0.04, 0.06, 0.00, -0.23, -0.55, -0.60, -0.45, -0.35, -0.29, -0.23, -0.13,
    ];

    /// <summary>
    /// Angle between the chord of the fore wing and the way of its own motion, as in still air, at t/T = 0, 0.02, … in degrees of 0 to 90:
    /// mean of five beats, measured on films and digitised by J. Pecquet; not a number around the upper turn, where fewer than four beats
    /// have points.
    /// </summary>
    public static IReadOnlyList<double> TetheredAttack { get; } =
    [
        23, 22, 21, 22, 25, 31, 35, double.NaN, double.NaN, double.NaN, double.NaN, double.NaN, double.NaN, 58, 67, 69, 60, 57, 60, 66, 74,
        81, 84, 84, 80, 76, 74, 74, 79, 85, 85, 80, 78, 80, 80, 78, 72, 63, 42, 19, 13, 16, 20, 23, 23, 23, 22, 22, 23, 23,
    ];

    /// <summary>Mean and largest value of that force in each of the five beats.</summary>
    public static IReadOnlyList<double> TetheredMeans { get; } = [1.00, 0.63, 0.64, 0.93, 0.85];
    public static IReadOnlyList<double> TetheredPeaks { get; } = [3.43, 2.60, 2.99, 3.92, 2.62];

    /// <summary>Least correlation of one of the beats with the mean of the other four.</summary>
    public const double TetheredLikeness = 0.89;

    /// <summary>Length of the body, m.</summary>
    public double BodyLength { get; init; } = 0.075;

    /// <summary>Half of the last printed digit of speed, m/s, and of the climb's angle, degrees.</summary>
    public double HalfSpeed { get; init; } = 0.05;
    public double HalfAngle { get; init; } = 0.05;

    /// <summary>Weight, newtons.</summary>
    public double Weight => Mass * EarthGravity.Precise;

    private static MeasuredDragonfly Flight(int number, double speed, double angle) => new(
        $"dragonfly-flight-{number}", speed * Math.Cos(angle * Math.PI / 180), speed * Math.Sin(angle * Math.PI / 180), 790e-6,
        s_AzumaLengths, s_AzumaAreas, k_Azuma);
}
