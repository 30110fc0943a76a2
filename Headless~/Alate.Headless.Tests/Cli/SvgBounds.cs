using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Law of every SVG page: it is as large as its ground, and all that is drawn lies on it.</summary>
internal static class SvgBounds
{
    private static readonly (string Across, string Along)[] s_Places = [("x", "y"), ("x1", "y1"), ("x2", "y2"), ("cx", "cy")];

    public static void AssertAllIsOnThePage(string file)
    {
        XElement page = XDocument.Load(file).Root;
        double[] box = [.. page.Attribute("viewBox").Value.Split(' ').Select(Number)];
        if (page.Attribute("width") is { } width)
            Assert.That((Number(width.Value), Number(page.Attribute("height").Value)), Is.EqualTo((box[2], box[3])), file);
        int count = 0;
        // What is clipped may begin beyond it.
        foreach (XElement shape in page.Descendants()
            .Where(shape => shape.AncestorsAndSelf().All(part => part.Attribute("clip-path") == null)))
        {
            foreach ((double x, double y) in Places(shape))
            {
                count++;
                if (!(x >= box[0] && x <= box[0] + box[2] && y >= box[1] && y <= box[1] + box[3]))
                    Assert.Fail($"{file}: {shape} is beyond the page, {page.Attribute("viewBox").Value}");
            }
        }

        Assert.That(count, Is.GreaterThan(10), file);
    }

    private static IEnumerable<(double X, double Y)> Places(XElement shape)
    {
        foreach ((string across, string along) in s_Places)
        {
            if (shape.Attribute(across) != null && shape.Attribute(along) != null)
                yield return (Number(shape, across), Number(shape, along));
        }

        if (shape.Name.LocalName == "rect" && shape.Attribute("x") != null)
            yield return (Number(shape, "x") + Number(shape, "width"), Number(shape, "y") + Number(shape, "height"));
        // Marks that are drawn from where the pen stands have a place of their own.
        string path = shape.Name.LocalName == "path" ? shape.Attribute("d").Value : "";
        if (Regex.IsMatch(path, "[a-y]"))
            yield break;
        double[] numbers = [.. Regex.Matches(path, @"-?[\d.]+").Select(number => Number(number.Value))];
        for (int k = 0; k + 1 < numbers.Length; k += 2)
            yield return (numbers[k], numbers[k + 1]);
    }

    private static double Number(XElement shape, string name) => Number(shape.Attribute(name).Value);

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
