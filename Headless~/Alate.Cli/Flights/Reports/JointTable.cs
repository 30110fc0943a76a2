namespace Alate.Cli;

/// <summary>
/// joints.csv: one row for every joint after every substep of the last beat. Positions are on the body, X right, Y up, Z ahead, metres
/// from the middle of the thorax; the bends are those of the joint at the root side of a bone, so the last joint of a chain has none.
/// </summary>
internal static class JointTable
{
    private static readonly string[] s_Header =
        ["time_s", "phase_deg", "wing", "side", "chain", "joint", "x_m", "y_m", "z_m", "bend_deg", "in_plane_deg", "torsion_deg"];

    public static IEnumerable<IReadOnlyList<string>> Of(FlightRecord flight) =>
        flight.Wings.SelectMany(wing => wing.Frames.SelectMany(frame => Rows(wing, frame))).Prepend(s_Header);

    private static IEnumerable<string[]> Rows(RecordedWing wing, RecordedFrame frame)
    {
        string time = Number(frame.Time, 7), phase = Number(180.0 / Math.PI * frame.Phase, 4),
            side = wing.Placement.IsLeft ? "left" : "right";
        for (int k = 0; k < frame.Joints.Length; k++)
        {
            int bones = wing.JointsPerChain - 1, chain = k / wing.JointsPerChain, joint = k % wing.JointsPerChain;
            string[] bends = joint == bones ? ["", "", ""] : Numbers(math.degrees(frame.Bends[chain * bones + joint]), 4);
            yield return
                [time, phase, wing.Wing.Name, side, $"{chain}", $"{joint}",
                    .. Numbers(wing.Placement.ToBody(frame.Joints[k]), 7), .. bends];
        }
    }

    private static string[] Numbers(float3 value, int digits) =>
        [Number(value.x, digits), Number(value.y, digits), Number(value.z, digits)];

    private static string Number(double value, int digits) => value.ToString("F" + digits, CultureInfo.InvariantCulture);
}
