using System.Text.Json;
using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>A number of a range, in its unit.</summary>
/// <param name="min">The least.</param>
/// <param name="max">The most.</param>
/// <param name="unit">In words; empty for a ratio.</param>
/// <param name="isWhole">True for whole numbers alone.</param>
internal sealed class NumberShape(decimal min, decimal max, string unit, bool isWhole = false) : FileShape
{
    /// <summary>Largest number that is taken.</summary>
    public decimal Most => max;

    public override string Words => min == max ? FormattableString.Invariant($"{min}") : FormattableString.Invariant(
        $"a {(isWhole ? "whole " : "")}number from {min} to {max}{(unit.Length == 0 ? "" : $" {unit}")}");

    public override JsonObject Schema() => new()
    {
        ["type"] = isWhole ? "integer" : "number",
        ["minimum"] = JsonValue.Create(min),
        ["maximum"] = JsonValue.Create(max),
    };

    public override void Check(JsonPlace value)
    {
        if (value.Kind != JsonTokenType.Number)
            throw Not(value);
        if (!FileNumber.TryRead(value.Text, out decimal number) || number < min || number > max
            || isWhole && number != decimal.Truncate(number))
        {
            throw value.Wrong($"{Quote.Of(value.Text)[1..^1]} is out of range: {Words} is allowed");
        }
    }
}
