using System.Text.RegularExpressions;

namespace Alate.Cli;

/// <summary>A quantity that is typed with its unit, such as 50mm, and the units in which it may be.</summary>
/// <param name="Name">What it is, such as 'length'.</param>
/// <param name="Unit">Unit of the numbers here.</param>
/// <param name="Least">Smallest, in that unit.</param>
/// <param name="Most">Largest, in that unit.</param>
/// <param name="Units">Units, each with how many of the unit here it is.</param>
internal sealed partial record Quantity(string Name, string Unit, decimal Least, decimal Most, params (string Name, decimal Size)[] Units)
{
    /// <summary>True where a number alone is in the unit here.</summary>
    public bool IsUnitKnown { get; init; }

    /// <summary>Reads a text.</summary>
    /// <param name="option">Who takes it, for messages.</param>
    /// <param name="text">A number and a unit, with or without a space between them.</param>
    /// <exception cref="UserException">It has no unit, another one, or is out of range; one line.</exception>
    public decimal Read(string option, string text)
    {
        string typed = text.Trim();
        string digits = Number().Match(typed).Value, unit = typed[digits.Length..].Trim();
        if (!double.TryParse(digits, NumberStyles.Float, CultureInfo.InvariantCulture, out double number))
            throw new UserException($"{option} takes a {Name} with its unit, such as {Examples("25")}, not {Quote.Of(text)}.");
        if (unit.Length == 0 && !IsUnitKnown)
            throw new UserException($"{option} {Quote.Of(typed)[1..^1]} has no unit: is it {Examples(digits)}?");
        decimal size = unit.Length == 0 ? 1 : Units.FirstOrDefault(known => known.Name == unit).Size;
        if (size == 0)
        {
            throw new UserException($"{option} takes a {Name} in {string.Join(", ", Units.Select(known => known.Name))}; "
                + $"{Quote.Of(unit)} is none of them.");
        }

        // Larger ones are no decimal numbers; a division by one with many digits strips zeros.
        decimal value = Math.Abs(number) > 1e15 ? decimal.MaxValue
            : Math.Round((decimal)number * size, 6) / 1.000000000000000000000000000m;
        return value >= Least && value <= Most
            ? value
            : throw new UserException(FormattableString.Invariant(
                $"{option} must lie between {Least} and {Most} {Unit}; {Quote.Of(typed)[1..^1]} does not."));
    }

    [GeneratedRegex(@"^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")]
    private static partial Regex Number();

    private string Examples(string number) => string.Join(" or ", Units.Take(3).Select(known => number + known.Name));
}
