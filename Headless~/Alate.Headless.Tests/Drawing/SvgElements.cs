using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Alate.Drawing;
using NUnit.Framework;

namespace Alate.Tests.Drawing;

/// <summary>Elements of a page, each in a line: "line x1=0 y1=2 ...", "text x=1 ... : its words".</summary>
internal static class SvgElements
{
    private const string k_Number = @"-?\d+(\.\d+)?";

    /// <summary>Everything between the paper and the page's end, in the order of painting.</summary>
    public static string[] Of(SvgPage page) =>
        [.. XElement.Parse(page.Finish(1000f, 1000f,
            "page")).Elements().Skip(3).SelectMany(element => element.DescendantsAndSelf()).Select(Told)];

    public static string Line(double x1, double y1, double x2, double y2, string colour, double thickness = 1) =>
        FormattableString.Invariant($"line x1={x1} y1={y1} x2={x2} y2={y2} stroke={colour} stroke-width={thickness}");

    public static string Text(double x, double y, double size, string text, string anchor = null, string look = null) =>
        FormattableString.Invariant($"text x={x} y={y} font-size={size}")
        + (anchor == null ? "" : $" text-anchor={anchor}") + (look == null ? "" : $" class={look}") + $" : {text}";

    /// <summary>Fails where the page has other elements than these, or numbers of them differ by more than the page rounds.</summary>
    public static void AssertAre(SvgPage page, IEnumerable<string> expected)
    {
        string[] drawn = Of(page), asked = [.. expected];
        Assert.That(drawn.Select(Form), Is.EqualTo(asked.Select(Form)));
        for (int k = 0; k < asked.Length; k++)
            Assert.That(Numbers(drawn[k]), Is.EqualTo(Numbers(asked[k])).Within(0.0501), $"{drawn[k]}, asked for {asked[k]}");
    }

    private static string Told(XElement element) => element.Name.LocalName
        + string.Concat(element.Attributes().Select(attribute => $" {attribute.Name.LocalName}={attribute.Value}"))
        + (element.Value.Length > 0 ? $" : {element.Value}" : "");

    private static string Form(string element) => Regex.Replace(element, k_Number, "#");

    private static double[] Numbers(string element) =>
        [.. Regex.Matches(element, k_Number).Select(number => double.Parse(number.Value, CultureInfo.InvariantCulture))];
}
