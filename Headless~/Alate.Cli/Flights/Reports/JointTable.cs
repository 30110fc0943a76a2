using System;
using System.Globalization;
using System.IO;
using System.Text;
using Unity.Mathematics;

namespace Alate.Cli;

/// <summary>
/// joints.csv: one row for every joint after every substep of the last beat. Positions are on the body, X right, Y up, Z ahead, metres
/// from the middle of
/// the thorax; the bends are those of the joint at the root side of a bone, so the last joint of a chain has none.
/// </summary>
internal static class JointTable
{
    private const string k_Header = "time_s,phase_deg,wing,side,chain,joint,x_m,y_m,z_m,bend_deg,in_plane_deg,torsion_deg";

    public static void Write(FlightRecord flight, Stream stream)
    {
        using var text = new StreamWriter(stream, new UTF8Encoding(false), leaveOpen: true) { NewLine = "\n" };
        text.WriteLine(k_Header);
        foreach (RecordedWing wing in flight.Wings)
        {
            foreach (RecordedFrame frame in wing.Frames)
                Write(wing, frame, text);
        }
    }

    private static void Write(RecordedWing wing, RecordedFrame frame, TextWriter text)
    {
        string side = wing.Placement.IsLeft ? "left" : "right";
        string prefix = $"{Number(frame.Time, 7)},{Number(180.0 / Math.PI * frame.Phase, 4)},{wing.Wing.Name},{side}";
        for (int k = 0; k < frame.Joints.Length; k++)
        {
            int bones = wing.JointsPerChain - 1, chain = k / wing.JointsPerChain, joint = k % wing.JointsPerChain;
            float3 place = wing.Placement.ToBody(frame.Joints[k]);
            text.Write($"{prefix},{chain},{joint},{Number(place.x, 7)},{Number(place.y, 7)},{Number(place.z, 7)},");
            text.WriteLine(joint == bones ? ",," : Bends(math.degrees(frame.Bends[chain * bones + joint])));
        }
    }

    private static string Bends(float3 degrees) => $"{Number(degrees.x, 4)},{Number(degrees.y, 4)},{Number(degrees.z, 4)}";

    private static string Number(double value, int digits) => value.ToString("F" + digits, CultureInfo.InvariantCulture);
}
