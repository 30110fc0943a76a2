namespace Alate.Drawing;

/// <summary>
/// Letters as strokes of a pen, for labels in pictures of pixels. A glyph is a list of strokes; a point is two digits, from the left and
/// from the top, with the base line at 7 and the height of small letters at 2. A stroke with a ~ is rounded.
/// </summary>
internal static class Lettering
{
    /// <summary>Of the size of the letters: height of a capital, and half the width of the pen.</summary>
    private const float k_Capital = 0.72f, k_Pen = 0.042f, k_BoldPen = 0.062f;

    private const float k_Narrow = 0.82f, k_Space = 2.3f, k_Base = 7f;
    private const int k_Rounds = 3;
    private const string k_Unknown = "00 40 47 07 00";

    private static readonly Dictionary<char, string> s_Glyphs = new()
    {
        ['0'] = "~20 40 47 07 00 20",
        ['1'] = "02 20 27",
        ['2'] = "~01 00 40 43 07/07 47",
        ['3'] = "~01 00 40 43 23/~23 43 47 07 06",
        ['4'] = "30 05 45/30 37",
        ['5'] = "40 00 03/~03 02 42 47 07 06",
        ['6'] = "~41 40 00 07 47 43 03 05",
        ['7'] = "00 40 17",
        ['8'] = "~20 40 43 03 00 20/~23 43 47 07 03 23",
        ['9'] = "~06 07 47 40 00 04 44 42",
        ['A'] = "07 20 47/15 35",
        ['B'] = "00 07/~00 40 43 03/~03 43 47 07",
        ['C'] = "~41 40 00 07 47 46",
        ['D'] = "00 07/~00 40 47 07",
        ['E'] = "40 00 07 47/03 33",
        ['F'] = "40 00 07/03 33",
        ['G'] = "~41 40 00 07 47 44/44 24",
        ['H'] = "00 07/40 47/03 43",
        ['I'] = "00 07",
        ['J'] = "~30 37 07 05",
        ['K'] = "00 07/40 04/14 47",
        ['L'] = "00 07 47",
        ['M'] = "07 00 34 60 67",
        ['N'] = "07 00 47 40",
        ['O'] = "~20 50 57 07 00 20",
        ['P'] = "07 00/~00 40 44 04",
        ['Q'] = "~20 50 57 07 00 20/36 58",
        ['R'] = "07 00/~00 40 44 04/24 47",
        ['S'] = "~41 40 00 03 43 47 07 06",
        ['T'] = "00 40/20 27",
        ['U'] = "00 05/~05 07 47 45/45 40",
        ['V'] = "00 27 40",
        ['W'] = "00 17 32 57 60",
        ['X'] = "00 47/40 07",
        ['Y'] = "00 23 40/23 27",
        ['Z'] = "00 40 07 47",
        ['a'] = "42 47/~44 42 02 07 47 44",
        ['b'] = "00 07/~04 02 42 47 07 04",
        ['c'] = "~43 42 02 07 47 46",
        ['d'] = "40 47/~44 42 02 07 47 44",
        ['e'] = "04 44/~44 42 02 07 47 46",
        ['f'] = "~30 10 14/14 17/02 32",
        ['g'] = "42 47/~46 49 09 08/~44 42 02 07 47 44",
        ['h'] = "00 07/~04 02 42 45/45 47",
        ['i'] = "02 07/00 00",
        ['j'] = "~12 19 09/10 10",
        ['k'] = "00 07/42 05/15 47",
        ['l'] = "00 07",
        ['m'] = "02 07/~04 02 32 35/35 37/~34 32 62 65/65 67",
        ['n'] = "02 07/~04 02 42 45/45 47",
        ['o'] = "~22 42 47 07 02 22",
        ['p'] = "02 09/~04 02 42 47 07 04",
        ['q'] = "42 49/~44 42 02 07 47 44",
        ['r'] = "02 07/~05 02 32",
        ['s'] = "~43 42 02 04 44 47 07 06",
        ['t'] = "10 15/~15 17 37/02 32",
        ['u'] = "02 05/~05 07 47 44/42 47",
        ['v'] = "02 27 42",
        ['w'] = "02 17 33 57 62",
        ['x'] = "02 47/42 07",
        ['y'] = "02 27/42 19",
        ['z'] = "02 42 07 47",
        ['.'] = "07 07",
        [','] = "17 08",
        [':'] = "03 03/07 07",
        [';'] = "13 13/17 08",
        ['-'] = "04 34",
        ['−'] = "04 44",
        ['–'] = "04 54",
        ['+'] = "04 44/22 26",
        ['='] = "03 43/05 45",
        ['±'] = "03 43/21 25/07 47",
        ['×'] = "03 36/33 06",
        ['²'] = "~01 10 21/21 03 23",
        ['°'] = "~10 20 22 02 00 10",
        ['%'] = "~10 20 22 02 00 10/50 07/~45 55 57 37 35 45",
        ['('] = "~20 03 04 27",
        [')'] = "~00 23 24 07",
        ['/'] = "30 07",
        ['\''] = "00 02",
        ['…'] = "07 07/27 27/47 47",
        ['†'] = "10 17/02 22",
        ['λ'] = "00 47/23 07",
        ['<'] = "42 04 46",
        ['>'] = "02 44 06",
        ['_'] = "08 48",
        ['&'] = "~47 02 00 30 32 05 07 27 44",
    };

    /// <summary>Width of a text.</summary>
    public static float Width(string text, float size) => Lay(text, size, out _);

    /// <summary>Strokes of a text that begins at the origin, on the base line, y down.</summary>
    /// <param name="text">Any characters; a box stands for those that have no glyph.</param>
    /// <param name="size">Size as fonts have it.</param>
    /// <param name="isBold">A broader pen.</param>
    public static (List<float2[]> Strokes, float Pen) Strokes(string text, float size, bool isBold)
    {
        Lay(text, size, out List<float2[]> strokes);
        return (strokes, size * (isBold ? k_BoldPen : k_Pen));
    }

    private static float Lay(string text, float size, out List<float2[]> strokes)
    {
        float unit = k_Capital * size / k_Base, x = 0f;
        strokes = [];
        foreach (char letter in text)
        {
            if (letter == ' ')
            {
                x += 2f * k_Space * unit * k_Narrow;
                continue;
            }

            float width = 0f;
            foreach (string stroke in (s_Glyphs.TryGetValue(letter, out string glyph) ? glyph : k_Unknown).Split('/'))
            {
                var points = stroke.TrimStart('~').Split(' ').Select(point => new float2(point[0] - '0', point[1] - '0' - k_Base)).ToList();
                width = math.max(width, points.Max(point => point.x));
                float left = x;
                strokes.Add((stroke[0] == '~' ? Rounded(points) : points)
                    .Select(point => unit * point * new float2(k_Narrow, 1f) + new float2(left, 0f)).ToArray());
            }

            x += (width + k_Space) * unit * k_Narrow;
        }

        return math.max(x - k_Space * unit * k_Narrow, 0f);
    }

    // Corners are cut (Chaikin 1974); the ends stay.
    private static List<float2> Rounded(List<float2> points)
    {
        for (int round = 0; round < k_Rounds; round++)
        {
            var cut = new List<float2> { points[0] };
            for (int k = 0; k + 1 < points.Count; k++)
                cut.AddRange([math.lerp(points[k], points[k + 1], 0.25f), math.lerp(points[k], points[k + 1], 0.75f)]);
            cut.Add(points[^1]);
            points = cut;
        }

        return points;
    }
}
