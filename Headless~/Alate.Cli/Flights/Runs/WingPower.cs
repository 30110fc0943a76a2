namespace Alate.Cli;

/// <summary>Powers of a wing, or of all, against the body, mean over a step, watts.</summary>
/// <param name="Air">Given to the air.</param>
/// <param name="Inertial">Taken by the motion of the wing's own mass.</param>
/// <param name="Positive">Mean of the positive part of both together, which the muscles give where nothing stores any.</param>
internal readonly record struct WingPower(double Air, double Inertial, double Positive)
{
    /// <summary>Mean of the negative part of both together, which the wing gives back to the muscles.</summary>
    public double Negative => Math.Min(Air + Inertial - Positive, 0.0);

    /// <summary>Powers of a wing in its last step.</summary>
    /// <param name="reading">The wing.</param>
    /// <param name="mass">Of the wing, kilograms.</param>
    /// <param name="length">Of the wing, metres.</param>
    public static WingPower Of(in WingReading reading, double mass, double length)
    {
        double unit = mass * length * length;
        return new WingPower(unit * reading.AirPower, unit * reading.InertialPower, unit * reading.PositivePower);
    }

    /// <summary>Sum of powers over a number of steps.</summary>
    public static WingPower Mean(IEnumerable<WingPower> powers, int steps)
    {
        WingPower sum = powers.Aggregate(default(WingPower), (all, one) => all + one);
        return new WingPower(sum.Air / steps, sum.Inertial / steps, sum.Positive / steps);
    }

    public static WingPower operator +(WingPower a, WingPower b) =>
        new(a.Air + b.Air, a.Inertial + b.Inertial, a.Positive + b.Positive);
}
