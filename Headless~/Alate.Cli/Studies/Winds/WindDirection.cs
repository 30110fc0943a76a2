namespace Alate.Cli;

/// <summary>A side from which wind comes upon a right wing.</summary>
/// <param name="From">1, 0 or −1 on each axis: the wing's tip or its root, above or below, ahead or behind.</param>
internal sealed record WindDirection(int3 From)
{
    private static readonly (string Positive, string Negative)[] s_Words = [("tip", "root"), ("above", "below"), ("ahead", "behind")];

    /// <summary>The 26 neighbours of a cube's centre.</summary>
    public static IReadOnlyList<WindDirection> All { get; } =
    [
        .. from x in Steps from y in Steps from z in Steps where x != 0 || y != 0 || z != 0 select new WindDirection(new int3(x, y, z)),
    ];

    /// <summary>From ahead.</summary>
    public static WindDirection HeadWind { get; } = All.First(direction => math.all(direction.From == new int3(0, 0, 1)));

    /// <summary>Name of the direction: <c>ahead below</c>.</summary>
    public string Name => string.Join(' ', Enumerable.Range(0, 3).Reverse().Where(axis => From[axis] != 0)
        .Select(axis => From[axis] > 0 ? s_Words[axis].Positive : s_Words[axis].Negative));

    private static int[] Steps => [-1, 0, 1];

    /// <summary>Velocity of the air, m/s: right, up, ahead.</summary>
    public double[] Velocity(double speed)
    {
        float3 to = -math.normalize((float3)From);
        return [speed * to.x, speed * to.y, speed * to.z];
    }
}
