using System.Linq;
using Alate.Cli.Flights;

namespace Alate.Cli.Parameters;

/// <summary>One number of a species at another value.</summary>
internal sealed record ParameterChange(FlownParameter Parameter, float Value)
{
    public void ApplyTo(Insect insect) => Parameter.Set(insect.Wings.Select(wing => wing.Species).ToList(), Value);
}
