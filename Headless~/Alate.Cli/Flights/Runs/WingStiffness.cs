namespace Alate.Cli;

/// <summary>
/// Flexural stiffness of a wing's chains, whether measured or made by the preset's factors: EI of the uniform cantilever that a force on
/// its tip bends as far down, N·m².
/// </summary>
/// <param name="Chains">[chain] From the leading to the trailing edge.</param>
/// <param name="Usual">Of measured wings of the same length.</param>
internal sealed record WingStiffness(double[] Chains, double Usual)
{
    /// <summary>Of the leading chain.</summary>
    public double Leading => Chains[0];

    /// <summary>Of all chains side by side.</summary>
    public double Whole => Chains.Sum();

    /// <summary>
    /// Torsional stiffness of all chains side by side: GJ of the uniform rods that a moment on the tip twists as far, N·m².
    /// </summary>
    public double Torsional { get; init; }

    /// <summary>Reads it from a wing's joints.</summary>
    public static WingStiffness Of(WingRig rig, in WingReading reading, in PresetSize size)
    {
        double unit = (double)size.wingMass * size.wingLength * size.wingLength * size.wingLength;
        int joints = rig.JointsPerChain;
        double[] chains = new double[rig.ChainCount];
        double torsional = 0;
        for (int i = 0; i < chains.Length; i++)
        {
            double beyond = 0, compliance = 0, twist = 0;
            for (int j = joints - 2; j >= 0; j--)
            {
                beyond += math.distance(rig.RestJoints[i * joints + j], rig.RestJoints[i * joints + j + 1]);
                compliance += beyond * beyond / reading.JointStiffness(i, j).x;
                twist += 1 / reading.JointStiffness(i, j).y;
            }

            chains[i] = unit * beyond * beyond * beyond / (3 * compliance);
            torsional += unit * beyond / twist;
        }

        return new WingStiffness(chains, UsualOf(size.wingLength)) { Torsional = torsional };
    }

    /// <summary>
    /// EI across the root of whole wings of 16 species against their span, metres: y = 2.97 x + 0.08 of the logarithms (Combes and Daniel
    /// 2003, J. exp. Biol. 206:2979, Fig. 4A).
    /// </summary>
    public static double UsualOf(double span) => Math.Pow(10, 0.08) * Math.Pow(span, 2.97);
}
