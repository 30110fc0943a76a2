namespace Alate.Cli;

/// <summary>One wing of the insect over its last beat.</summary>
internal sealed class RecordedWing
{
    public InsectWing Wing { get; init; }
    public WingMount Placement { get; init; }
    public WingParameters Parameters { get; set; }

    /// <summary>Side and kind of the wing, such as 'left fore wing'.</summary>
    public string SideAndName => $"{(Placement.IsLeft ? "left" : "right")} {Wing.Name}";

    /// <summary>[vertex] Wing frame, wing lengths.</summary>
    public float3[] Rest { get; init; }

    /// <summary>Measures the wing's shapes.</summary>
    public BeatMeasurement Measurement { get; init; }

    /// <summary>Three vertex indices a triangle, as the mesh has them.</summary>
    public int[] Triangles { get; init; }

    public int ChainCount { get; init; }
    public int JointsPerChain { get; init; }

    /// <summary>Summary of the wing's joints.</summary>
    public WingStiffness Stiffness { get; init; }

    /// <summary>True for the mesh of a left wing, whose triangles wind the other way in the wing frame.</summary>
    public bool IsMeshMirrored { get; init; }

    /// <summary>Hertz.</summary>
    public float Frequency { get; set; }

    /// <summary>Flap that the beat drives, radians from end to end.</summary>
    public float Flap { get; init; }

    /// <summary>Number of times the wing fell back to its driven pose.</summary>
    public int Resets { get; set; }

    /// <summary>Frames in order of time, one beat.</summary>
    public List<RecordedFrame> Frames { get; } = [];

    /// <summary>The frames as they are measured.</summary>
    public List<BeatFrame> Beat => Frames.ConvertAll(frame => new BeatFrame(frame.Phase, frame.Root, frame.Positions));

    /// <summary>The wing at a phase, between the two frames that enclose it.</summary>
    /// <param name="turns">Beats, 0 to 1.</param>
    /// <returns>[vertex] On the body, metres, and of unit length.</returns>
    public (float3[] Positions, float3[] Normals) At(double turns)
    {
        float3[] positions = new float3[Rest.Length], normals = new float3[Rest.Length];
        (RecordedFrame before, RecordedFrame after, float share) = Around(turns);
        for (int k = 0; k < positions.Length; k++)
        {
            positions[k] = Placement.ToBody(math.lerp(before.Positions[k], after.Positions[k], share));
            normals[k] = Placement.DirectionToBody(math.normalizesafe(math.lerp(before.Normals[k], after.Normals[k], share)));
        }

        return (positions, normals);
    }

    /// <summary>The joints at a phase, between the two frames that enclose it.</summary>
    /// <param name="turns">Beats, 0 to 1.</param>
    /// <param name="joints">[chain · joints + joint] Wing frame, wing lengths.</param>
    public void JointsAt(double turns, float3[] joints)
    {
        (RecordedFrame before, RecordedFrame after, float share) = Around(turns);
        for (int k = 0; k < joints.Length; k++)
            joints[k] = math.lerp(before.Joints[k], after.Joints[k], share);
    }

    /// <summary>
    /// Power that the wing gives to the air in a frame, less force times velocity by the joints' places before and after; the beat repeats.
    /// Wing masses · L²/s³; needs recorded loads of the air.
    /// </summary>
    public double Power(int frame)
    {
        int count = Frames.Count;
        float3[] before = Frames[(frame + count - 1) % count].Joints, after = Frames[(frame + 1) % count].Joints,
            loads = Frames[frame].AirLoads;
        double rate = 0.5 * count * Frequency;
        return -Enumerable.Range(0, loads.Length).Sum(joint => rate * math.dot(loads[joint], after[joint] - before[joint]));
    }

    /// <summary>The two frames that enclose a phase, and how far it lies between them.</summary>
    /// <param name="turns">Beats.</param>
    public (RecordedFrame Before, RecordedFrame After, float Share) Around(double turns)
    {
        double wanted = Turn(turns);
        RecordedFrame before = Frames[0], after = Frames[0];
        double back = double.MaxValue, on = double.MaxValue;
        foreach (RecordedFrame frame in Frames)
        {
            double phase = frame.Phase / (2.0 * Math.PI);
            double behind = Turn(wanted - phase), ahead = Turn(phase - wanted);
            (back, before) = behind < back ? (behind, frame) : (back, before);
            (on, after) = ahead < on ? (ahead, frame) : (on, after);
        }

        return (before, after, back + on > 0.0 ? (float)(back / (back + on)) : 0f);
    }

    private static double Turn(double turns) => turns - Math.Floor(turns);
}
