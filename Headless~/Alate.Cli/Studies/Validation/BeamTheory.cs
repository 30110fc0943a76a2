using System.Numerics;

namespace Alate.Cli;

/// <summary>Uniform cantilevers of length 1, mass 1 and flexural stiffness 1 in double precision, apart from the wing model.</summary>
internal static class BeamTheory
{
    /// <summary>First bending frequency, rad per unit of time: the square of the least root of cos λ cosh λ = −1.</summary>
    public const double First = 3.5160152685;

    private const int k_Parts = 2000, k_Halvings = 50;

    /// <summary>Depth of the tip under the beam's own weight, which stays vertical however far it bends (the elastica).</summary>
    public static double Droop(double weight)
    {
        // θ' = M, M' = −w (1 − s) cos θ; the moment at the root is halved in until none is left at the tip.
        double low = 0, high = weight, depth = 0;
        for (int k = 0; k < k_Halvings; k++)
        {
            double root = 0.5 * (low + high), angle = 0, moment = root, step = 1.0 / k_Parts;
            depth = 0;
            for (int n = 0; n < k_Parts; n++)
            {
                double middle = angle + 0.5 * step * moment, half = moment - 0.5 * step * weight * (1 - n * step) * Math.Cos(angle);
                depth += step * Math.Sin(middle);
                angle += step * half;
                moment -= step * weight * (1 - (n + 0.5) * step) * Math.Cos(middle);
            }

            (low, high) = moment > 0 ? (low, root) : (root, high);
        }

        return depth;
    }

    /// <summary>Motion of the tip against a clamp that is shaken by 1 across the beam: a complex amplitude.</summary>
    /// <param name="ratio">Frequency over the first bending frequency.</param>
    /// <param name="damping">Damping ratio of the first mode, by a strain rate: EI (1 + 2iζ ω/ω₁).</param>
    public static Complex Shaken(double ratio, double damping)
    {
        Complex wave = Wave(ratio, damping), cos = Complex.Cos(wave), cosh = Complex.Cosh(wave);
        return (cos + cosh) / (1 + cos * cosh) - 1;
    }

    /// <summary>Motion of the tip against the beam's undeformed line, whose root is turned by 1.</summary>
    /// <inheritdoc cref="Shaken"/>
    public static Complex Turned(double ratio, double damping)
    {
        // W = a (cos − cosh) + b (sin − sinh) + sinh/λ, without moment and shear at the tip.
        Complex wave = Wave(ratio, damping);
        Complex even = Complex.Cos(wave) + Complex.Cosh(wave), sin = Complex.Sin(wave), sinh = Complex.Sinh(wave),
            cosh = Complex.Cosh(wave);
        Complex under = even * even - (sinh - sin) * (sin + sinh);
        Complex a = (sinh * even - (sin + sinh) * cosh) / (wave * under), b = (even * cosh - (sinh - sin) * sinh) / (wave * under);
        return a * (Complex.Cos(wave) - cosh) + b * (sin - sinh) + sinh / wave - 1;
    }

    private static Complex Wave(double ratio, double damping) =>
        Complex.Pow(ratio * ratio * First * First / (1 + new Complex(0, 2 * damping * ratio)), 0.25);
}
