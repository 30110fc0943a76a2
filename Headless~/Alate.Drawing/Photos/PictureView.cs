namespace Alate.Drawing;

/// <summary>A side from which insects are looked at.</summary>
/// <param name="Words">The side in words, after "from".</param>
/// <param name="Aside">Degrees from straight ahead of the insect towards its left.</param>
/// <param name="Above">Degrees above its horizontal plane, -90 to 90.</param>
internal readonly record struct PictureView(string Words, float Aside, float Above)
{
    public static readonly PictureView FrontLeft = new("the front left", 36f, 28f);

    /// <summary>Names of the sides on the command line.</summary>
    public static readonly Dictionary<string, PictureView> ByName = new()
    {
        ["front-left"] = FrontLeft,
        ["front"] = new("the front", 0f, 8f),
        ["side"] = new("the left side", 90f, 4f),
        ["top"] = new("above", 180f, 90f),
        ["back"] = new("behind", 180f, 24f),
    };
}
