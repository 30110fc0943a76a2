using System;
using System.Globalization;
using System.Linq;

namespace UnityEngine;

/// <summary>Numbers written as Unity writes vectors: in parentheses, with points.</summary>
internal static class Numbers
{
    public static string Tuple(string format, string usual, IFormatProvider provider, params float[] values)
    {
        string chosen = string.IsNullOrEmpty(format) ? usual : format;
        IFormatProvider culture = provider ?? CultureInfo.InvariantCulture.NumberFormat;
        return $"({string.Join(", ", values.Select(v => v.ToString(chosen, culture)))})";
    }
}
