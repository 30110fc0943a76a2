using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;

namespace Alate.Cli.Commands;

/// <summary>Options that take numbers within a range; anything else is one clear error.</summary>
internal static class Numbers
{
    /// <summary>A number that has a default.</summary>
    public static Option<double> Option(string name, string unit, double fallback, double min, double max, string description) =>
        new(name)
        {
            Description = description,
            HelpName = unit,
            DefaultValueFactory = _ => fallback,
            CustomParser = result => Parse(result, name, Text(result), min, max),
        };

    /// <summary>A number whose default depends on others.</summary>
    public static Option<double?> Optional(string name, string unit, double min, double max, string description) =>
        new(name)
        {
            Description = description,
            HelpName = unit,
            CustomParser = result => Parse(result, name, Text(result), min, max),
        };

    /// <summary>A whole number whose default depends on others.</summary>
    public static Option<int?> OptionalCount(string name, string unit, int min, int max, string description) =>
        new(name)
        {
            Description = description,
            HelpName = unit,
            CustomParser = result => Count(result, name, Text(result), min, max),
        };

    /// <summary>Three numbers with commas; an empty array when it is not given.</summary>
    public static Option<double[]> Vector(string name, string unit, double limit, string description) =>
        new(name)
        {
            Description = description,
            HelpName = unit,
            CustomParser = result => Three(result, name, limit),
        };

    private static double[] Three(ArgumentResult result, string name, double limit)
    {
        string[] parts = Text(result).Split(',');
        if (parts.Length != 3)
        {
            result.AddError($"{name} takes three numbers with commas, such as 0,0,-1, not '{Text(result)}'.");
            return null;
        }

        var vector = new double[3];
        for (int k = 0; k < 3; k++)
            vector[k] = Parse(result, name, parts[k], -limit, limit);
        return vector;
    }

    private static double Parse(ArgumentResult result, string name, string text, double min, double max)
    {
        bool isNumber = double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value);
        if (!isNumber || !double.IsFinite(value))
            result.AddError($"{name} takes a finite number, not '{text}'.");
        else if (value < min || value > max)
            result.AddError(string.Create(CultureInfo.InvariantCulture, $"{name} must lie between {min} and {max}; it is {value}."));
        return value;
    }

    private static int? Count(ArgumentResult result, string name, string text, int min, int max)
    {
        bool isNumber = long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long value);
        if (!isNumber)
            result.AddError($"{name} takes a whole number, not '{text}'.");
        else if (value < min || value > max)
            result.AddError($"{name} must lie between {min} and {max}; it is {value}.");
        return (int)long.Clamp(value, min, max);
    }

    private static string Text(SymbolResult result) => result.Tokens.Count > 0 ? result.Tokens[0].Value : "";
}
