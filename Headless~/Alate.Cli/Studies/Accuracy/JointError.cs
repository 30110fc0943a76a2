namespace Alate.Cli;

/// <summary>Measures the distance between the joints of two flights of one wing at equal phase.</summary>
internal static class JointError
{
    /// <summary>Root mean square over all joints and the frames of a beat, per cent of the wing's length.</summary>
    /// <param name="wing">The flight that is judged.</param>
    /// <param name="reference">The flight it should equal; its frames are interpolated.</param>
    public static double Percent(RecordedWing wing, RecordedWing reference)
    {
        var expected = new float3[wing.Frames[0].Joints.Length];
        double sum = 0.0;
        foreach (RecordedFrame frame in wing.Frames)
        {
            reference.JointsAt(frame.Phase / (2.0 * Math.PI), expected);
            for (int k = 0; k < expected.Length; k++)
                sum += math.distancesq(frame.Joints[k], expected[k]);
        }

        return 100.0 * Math.Sqrt(sum / (wing.Frames.Count * expected.Length));
    }
}
