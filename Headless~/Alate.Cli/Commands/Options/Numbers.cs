using System.CommandLine;
using System.CommandLine.Parsing;

namespace Alate.Cli;

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

    /// <summary>A number of a flight that has a default.</summary>
    public static Option<double> Option(FlightNumber number) =>
        Option(number.Option, number.Word, number.Default, number.Min, number.Max, number.Help);

    /// <summary>A number of a flight whose default depends on others.</summary>
    public static Option<double?> Optional(FlightNumber number) =>
        Optional(number.Option, number.Word, number.Min, number.Max, number.Help);

    /// <summary>A number of a flight whose option may stand alone, which means its default; null when it is not given.</summary>
    public static Option<double?> Switch(FlightNumber number) => new(number.Option)
    {
        Description = number.Help,
        HelpName = number.Word,
        Arity = ArgumentArity.ZeroOrOne,
        CustomParser = result =>
            result.Tokens.Count == 0 ? number.Default : Parse(result, number.Option, Text(result), number.Min, number.Max),
    };

    /// <summary>A whole number of a flight whose default depends on others.</summary>
    public static Option<int?> OptionalCount(FlightNumber number) =>
        OptionalCount(number.Option, number.Word, (int)number.Min, (int)number.Max, number.Help);

    /// <summary>Three numbers of a flight with commas; an empty array when they are not given.</summary>
    public static Option<double[]> Vector(FlightNumber number) => Vector(number.Option, number.Word, number.Max, number.Help);

    /// <summary>A number that must be given.</summary>
    public static Argument<double> Argument(string name, string description) =>
        new(name)
        {
            Description = description,
            CustomParser = result => Parse(result, name, Text(result), double.MinValue, double.MaxValue),
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
            CustomParser = result => Several(result, name, 3, "three numbers with commas, such as 0,0,-1", -limit, limit),
        };

    /// <summary>Two numbers with a comma; an empty array when it is not given.</summary>
    public static Option<double[]> Pair(string name, string unit, double min, double max, string description) =>
        new(name)
        {
            Description = description,
            HelpName = unit,
            CustomParser = result => Several(result, name, 2, "two numbers with a comma, such as 120,85", min, max),
        };

    /// <summary>Numbers with commas; an empty array when it is not given.</summary>
    public static Option<double[]> List(string name, string unit, int most, double min, double max, string description) =>
        new(name)
        {
            Description = description,
            HelpName = unit,
            CustomParser = result =>
            {
                int count = Text(result).Split(',').Length;
                return Several(result, name, Math.Min(count, most), $"1 to {most} numbers with commas", min, max);
            },
        };

    private static double[] Several(ArgumentResult result, string name, int count, string wanted, double min, double max)
    {
        string[] parts = Text(result).Split(',');
        if (parts.Length != count)
        {
            result.AddError($"{name} takes {wanted}, not {Quote.Of(Text(result))}.");
            return null;
        }

        double[] numbers = new double[count];
        for (int k = 0; k < count; k++)
            numbers[k] = Parse(result, name, parts[k], min, max);
        return numbers;
    }

    private static double Parse(ArgumentResult result, string name, string text, double min, double max)
    {
        bool isNumber = double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value);
        if (!isNumber || !double.IsFinite(value))
            result.AddError($"{name} takes a finite number, not {Quote.Of(text)}.");
        else if (value < min || value > max)
            result.AddError(string.Create(CultureInfo.InvariantCulture, $"{name} must lie between {min} and {max}; it is {value}."));
        return value;
    }

    private static int? Count(ArgumentResult result, string name, string text, int min, int max)
    {
        bool isNumber = long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long value);
        if (!isNumber)
            result.AddError($"{name} takes a whole number, not {Quote.Of(text)}.");
        else if (value < min || value > max)
            result.AddError($"{name} must lie between {min} and {max}; it is {value}.");
        return (int)long.Clamp(value, min, max);
    }

    private static string Text(SymbolResult result) => result.Tokens.Count > 0 ? result.Tokens[0].Value : "";
}
